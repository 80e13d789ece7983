// An HDF5 file, opened for reading. Nothing in it is trusted before it is checked.
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

/// The words with which messages name the kind of file.
struct Wording {
  std::string kind;    ///< "model"
  std::string writer;  ///< "ritz-reduce"
};

/// An open file, and the name that messages use for it.
class StoredFile {
 public:
  /// `name` stands for the path in messages. Throws InputError when there is no such file, or it is not a regular file,
  /// ends in .part (half-written), is not HDF5, or is truncated.
  StoredFile(const std::filesystem::path& path, std::string name, Wording wording);
  /// The same from the bytes of a file, which are copied.
  StoredFile(std::span<const std::byte> image, std::string name, Wording wording);

  hid_t file() const { return file_.get(); }
  /// The name that messages use.
  const std::string& name() const { return name_; }
  const Wording& wording() const { return wording_; }

 private:
  std::string name_;
  Wording wording_;
  File file_;
};

/// Whether the file has an object of this path. Throws InputError when the file is too damaged to tell.
bool exists(const StoredFile& in, const std::string& path);

/// The value of attribute `name` of `object`. Throws InputError unless it holds one value of exactly this type.
double read_double(const StoredFile& in, const std::string& object, const char* name);
std::int64_t read_index(const StoredFile& in, const std::string& object, const char* name);
std::uint64_t read_bits(const StoredFile& in, const std::string& object, const char* name);
std::string read_text(const StoredFile& in, const std::string& object, const char* name);
/// Whether `object` has an attribute `name`.
bool has_attribute(const StoredFile& in, const std::string& object, const char* name);

/// How a dataset may be stored. own: as ritz writes it, one contiguous block of little-endian numbers or fixed-length
/// texts. foreign: floating point numbers of any size and byte order, also in chunks and compressed by HDF5's own
/// filters. Neither allows numbers in other files; foreign does not allow views of other datasets.
enum class Storage { own, foreign };

struct StoredObject {
  enum class Kind { group, dataset, view };
  std::string path;  ///< one of its names: the first that is found
  Kind kind;
  Shape shape;  ///< of a dataset or view
};

/// Lists the objects `roots` (links of "/") that the file has, and everything below those that are groups, each object
/// once, before HDF5 decodes any of it. Throws InputError for an object that is not reached by hard links alone, for a
/// group with two names, and for a dataset that is not stored as `storage` allows or that claims more numbers than the
/// file can hold. A view is listed, but must never be opened.
std::vector<StoredObject> survey(const StoredFile& in, std::span<const std::string_view> roots,
                                 Storage storage = Storage::own);

/// Reads the whole dataset and compares its checksum. Throws InputError when it differs or is missing.
void verify_rows(const StoredFile& in, const std::string& path);

/// Reads rows [first, first + count) of a dataset of float64 of shape `expected` into `values`. Throws InputError for
/// another shape or type, and for a number that is not finite. Does not verify the checksum.
void read_rows(const StoredFile& in, const std::string& path, const Shape& expected, std::int64_t first,
               std::int64_t count, double* values);

}  // namespace ritz::format
