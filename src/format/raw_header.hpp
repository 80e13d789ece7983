// What an HDF5 object header says of a dataset or a group, read from the file's bytes: HDF5 itself follows whatever
// stands there, and in a damaged heap without end.
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
  Shape shape;  ///< empty: one value
  std::uint8_t value_class = 0;
  std::uint64_t value_bytes = 0;
  Layout layout = Layout::contiguous;
  std::uint64_t address = 0, bytes = 0;  ///< where a contiguous dataset's numbers stand; of a view, its heap
  std::uint32_t heap_object = 0;         ///< a view's mapping in that heap
  bool external = false;                 ///< its numbers stand in other files
  std::vector<std::uint16_t> filters;    ///< HDF5's numbers of them
};

/// Its message completes "PATH ...".
struct BadHeader : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The header at `address` (as H5O_info_t gives it). Throws BadHeader.
RawHeader raw_header(const RawFile& file, std::uint64_t address);

/// Throws BadHeader where a link in the header of the group at `address` is none that HDF5 can decode: HDF5 1.10 frees
/// a table of links that it could not fill. A group of many links keeps them in a heap, which is not looked at here.
void check_links(const RawFile& file, std::uint64_t address);

/// Whether object `index` of the global heap collection at `address` is a view's mapping with the checksum that it was
/// written with. The heap itself has none: HDF5 1.10 walks a damaged one for ever, and follows a damaged mapping beyond
/// its end before it looks at the checksum.
bool sound_mapping(const RawFile& file, std::uint64_t address, std::uint32_t index);

}  // namespace ritz::format
