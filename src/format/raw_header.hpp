// Reads HDF5 object headers of datasets and groups from the bytes of a file, because HDF5 itself trusts whatever it
// finds there and may loop for ever in a damaged heap.
#pragma once
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "ritz/format/stored_file.hpp"

namespace ritz::format {

class RawFile;

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
