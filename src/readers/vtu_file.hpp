// Reads VTK XML files: the document, DataArrays as numbers, and encoded bytes.
#pragma once
#include <optional>
#include <pugixml.hpp>
#include <vector>

#include "ritz/readers/source.hpp"

namespace ritz::readers {

enum class VtuEncoding { base64, raw };
enum class VtuCompression { none, zlib, lz4, lzma };
enum class VtuOrder { little, big };  ///< which byte of a number comes first

/// How a file encodes its blocks of binary data.
struct VtuBlocks {
  VtuCompression compression = VtuCompression::none;
  std::size_t header_size = 4;        ///< bytes of each header number: 4 or 8
  VtuOrder order = VtuOrder::little;  ///< of header numbers and of data
};

/// Encoded data.
struct VtuText {
  std::string_view text;
  VtuEncoding encoding;
  Place place;  ///< for errors
};

/// Decodes the block at the start of `data`. Memory is limited by the length of the text, not by the size that the
/// block states. Throws InputError for truncated or corrupt data.
std::string decode(const Sources& sources, const VtuText& data, const VtuBlocks& blocks);

struct VtuFile {
  const Sources& sources;
  unsigned file;
  pugi::xml_document document;
  VtuBlocks blocks = {};
  std::optional<VtuText> appended = std::nullopt;  ///< the text from which offsets of appended arrays count

  Place place(const pugi::xml_node& node) const;
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& message) const;
};

/// Parses the XML (without raw appended data) and checks the header. Throws InputError.
VtuFile open_vtu(const Sources& sources, unsigned file);

/// The attribute as a number >= 0, or `otherwise` if it is absent. Throws InputError.
Index attribute(const VtuFile& vtu, const pugi::xml_node& node, const char* name, std::optional<Index> otherwise = {});

/// Whether the type of the array is an integer; is_byte: an 8-bit integer.
bool is_integer(const pugi::xml_node& array);
bool is_byte(const pugi::xml_node& array);

/// The numbers of a DataArray. Throws InputError unless there are exactly `count`, all finite.
std::vector<double> reals(const VtuFile& vtu, const pugi::xml_node& array, Index count);
/// The same for integers. Throws InputError for an array of floating-point type.
std::vector<Index> integers(const VtuFile& vtu, const pugi::xml_node& array, Index count);

}  // namespace ritz::readers
