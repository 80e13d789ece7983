// The binary data of a VTK XML file: raw or base64, plain or compressed by zlib, LZ4 or LZMA.
#pragma once
#include "ritz/mesh/read_source.hpp"

namespace ritz::mesh {

enum class VtuEncoding { base64, raw };
enum class VtuCompression { none, zlib, lz4, lzma };
enum class VtuOrder { little, big };  ///< which byte of a number comes first

/// How a file writes its blocks of binary data.
struct VtuBlocks {
  VtuCompression compression = VtuCompression::none;
  std::size_t header_size = 4;        ///< bytes of each header number: 4 or 8
  VtuOrder order = VtuOrder::little;  ///< of header numbers and of the data
};

/// Where encoded data stands.
struct VtuText {
  std::string_view text;
  VtuEncoding encoding;
  Place place;  ///< named by errors
};

/// Decodes the block at the start of `data`. Memory is bounded by what the text can hold, not by what it states.
/// Throws InputError for data that is cut off or corrupt.
std::string decode(const Sources& sources, const VtuText& data, const VtuBlocks& blocks);

}  // namespace ritz::mesh
