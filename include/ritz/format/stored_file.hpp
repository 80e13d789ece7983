// An HDF5 file that another run wrote, open for reading. Nothing in it is believed before it is checked.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/format/handle.hpp"

namespace ritz::format {

using Shape = std::vector<std::int64_t>;

/// How messages speak of a file.
struct Wording {
  std::string kind;    ///< "model"
  std::string writer;  ///< "ritz-reduce"
};

class StoredFile {
 public:
  /// `name` stands for the path in messages. Throws InputError: no such file, not a regular file, a half-written .part,
  /// not HDF5, truncated.
  StoredFile(const std::filesystem::path& path, std::string name, Wording wording);
  /// The same from the file's bytes, which are copied.
  StoredFile(std::span<const std::byte> image, std::string name, Wording wording);

  hid_t file() const { return file_.get(); }
  /// What messages call it.
  const std::string& name() const { return name_; }
  const Wording& wording() const { return wording_; }

 private:
  std::string name_;
  Wording wording_;
  File file_;
};

/// Whether there is such an object. Throws InputError where the file is too damaged to tell.
bool exists(const StoredFile& in, const std::string& path);

/// Attributes that hold one value of just this type. Throws InputError for all else.
double read_double(const StoredFile& in, const std::string& object, const char* name);
std::int64_t read_index(const StoredFile& in, const std::string& object, const char* name);
std::uint64_t read_bits(const StoredFile& in, const std::string& object, const char* name);
std::string read_text(const StoredFile& in, const std::string& object, const char* name);
bool has_attribute(const StoredFile& in, const std::string& object, const char* name);

/// What a file keeps its numbers in. own: as ritz writes them, one block of little-endian numbers or fixed-length
/// texts. foreign: floating point numbers of any size and order, also in chunks and packed by HDF5's own filters.
/// Neither: views of other datasets or files, whose reading has no end in a damaged file.
enum class Storage { own, foreign };

struct StoredObject {
  enum class Kind { group, dataset, view };
  std::string path;  ///< the first of its names
  Kind kind;
  Shape shape;  ///< of a dataset or view
};

/// Those of the objects `roots` (links of "/") that there are and, of groups, all below them, each once, before HDF5
/// decodes any of it. Throws InputError for what is not reached by hard links alone, for a group of two names, and for
/// datasets that are not kept as `storage` says or that claim more numbers than the file can hold. A view is listed,
/// and is never to be opened.
std::vector<StoredObject> survey(const StoredFile& in, std::span<const std::string_view> roots,
                                 Storage storage = Storage::own);

/// Reads all of a dataset and compares its checksum. Throws InputError when it differs or there is none.
void verify_rows(const StoredFile& in, const std::string& path);

/// Reads rows [first, first + count) of a dataset of float64 of the shape `expected`. Throws InputError for another
/// shape or type, and for a number that is not finite; the checksum is not looked at.
void read_rows(const StoredFile& in, const std::string& path, const Shape& expected, std::int64_t first,
               std::int64_t count, double* values);

}  // namespace ritz::format
