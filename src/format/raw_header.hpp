// Reads HDF5 object headers of datasets and groups from the bytes of a file that HDF5 has opened, because HDF5 itself
// trusts whatever it finds there and may loop for ever in a damaged heap.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "hdf5.hpp"
#include "ritz/format/stored_file.hpp"

namespace ritz::format {

/// Throws BadHeader.
[[noreturn]] void bad_header();

/// A file opened with HDF5's POSIX or in-memory driver.
class RawFile {
 public:
  explicit RawFile(hid_t file);
  std::uint64_t size() const { return size_; }
  /// The bytes [at, at + count). Throws BadHeader when the file does not have them, and for more than 64 MB.
  std::vector<unsigned char> bytes(std::uint64_t at, std::uint64_t count) const;

 private:
  hsize_t size_ = 0;
  const unsigned char* memory_ = nullptr;
  int descriptor_ = -1;
};

/// Reads bytes and numbers one after another. Throws BadHeader past the end.
class Cursor {
 public:
  explicit Cursor(std::span<const unsigned char> bytes) : left_(bytes) {}

  std::size_t size() const { return left_.size(); }
  std::span<const unsigned char> take(std::size_t count);
  std::uint64_t number(std::size_t bytes);

 private:
  std::span<const unsigned char> left_;
};

enum class Layout : std::uint8_t { compact = 0, contiguous = 1, chunked = 2, view = 3 };
enum class ValueClass : std::uint8_t { integer = 0, real = 1, text = 3 };

struct RawHeader {
  Shape shape;  ///< empty: a single value
  std::uint8_t value_class = 0;
  std::uint64_t value_bytes = 0;
  Layout layout = Layout::contiguous;
  std::uint64_t address = 0, bytes = 0;  ///< of the numbers of a contiguous dataset; for a view, of its heap
  std::uint32_t heap_object = 0;         ///< for a view: its mapping in that heap
  bool external = false;                 ///< whether its numbers are in other files
  std::vector<std::uint16_t> filters;    ///< HDF5's numbers of its filters
};

/// The message completes a sentence that begins with the path.
struct BadHeader : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The header at `address` (as in H5O_info_t). Throws BadHeader when it is damaged.
RawHeader raw_header(const RawFile& file, std::uint64_t address);

/// Throws BadHeader when HDF5 cannot decode a link in the header of the group at `address`; HDF5 1.10 would then free a
/// table of links that is only partly filled. Groups with many links keep them in a heap, which is not checked here.
void check_links(const RawFile& file, std::uint64_t address);

/// Whether object `index` of the global heap collection at `address` is the mapping of a view with a correct checksum.
/// The heap itself has no checksum: HDF5 1.10 reads a damaged heap without end, and reads beyond the end of a damaged
/// mapping before it checks the mapping's checksum.
bool sound_mapping(const RawFile& file, std::uint64_t address, std::uint32_t index);

}  // namespace ritz::format
