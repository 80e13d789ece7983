#include <algorithm>
#include <charconv>

#include "ritz/mesh/read_vtu_array.hpp"

namespace ritz::mesh {
namespace {

// Appended data may be anything, so the XML is cut off before it.
struct Cut {
  std::string xml;
  std::optional<VtuText> appended;
};

Cut cut_appended(const Sources& sources, unsigned file) {
  const std::string_view bytes = sources[file].bytes;
  const auto begin = bytes.find("<AppendedData");
  if (begin == std::string_view::npos) return {.xml = std::string(bytes), .appended = std::nullopt};
  const Place place{.file = file, .offset = begin};
  const auto tag_end = bytes.find('>', begin);
  const auto mark = bytes.find('_', std::min(tag_end, bytes.size()));
  if (mark == std::string_view::npos)
    fail(sources, place, "the appended data does not begin with '_'; it is truncated");
  const auto tag = bytes.substr(begin, tag_end - begin);
  const bool raw = tag.find("\"raw\"") != std::string_view::npos || tag.find("'raw'") != std::string_view::npos;
  return {
      .xml = std::string(bytes.substr(0, begin)) + "</VTKFile>",
      .appended = VtuText{
          .text = bytes.substr(mark + 1), .encoding = raw ? VtuEncoding::raw : VtuEncoding::base64, .place = place}};
}

void check_header(VtuFile& vtu) {
  const auto root = vtu.document.child("VTKFile");
  if (!root) fail(vtu.sources, "the file has no <VTKFile> element; it is not a VTK XML file");
  const std::string type = root.attribute("type").value();
  if (type != "UnstructuredGrid") vtu.fail(root, "the file holds '" + type + "', not an UnstructuredGrid");
  const std::string order = root.attribute("byte_order").as_string("LittleEndian");
  if (order != "LittleEndian" && order != "BigEndian")
    vtu.fail(root, "byte order " + order + " is not LittleEndian or BigEndian");
  vtu.blocks.order = order == "BigEndian" ? VtuOrder::big : VtuOrder::little;
  const std::string header = root.attribute("header_type").as_string("UInt32");
  if (header != "UInt32" && header != "UInt64") vtu.fail(root, "header type " + header + " is not UInt32 or UInt64");
  vtu.blocks.header_size = header == "UInt64" ? 8 : 4;
  const std::string compressor = root.attribute("compressor").value();
  if (compressor == "vtkZLibDataCompressor") vtu.blocks.compression = VtuCompression::zlib;
  else if (compressor == "vtkLZ4DataCompressor") vtu.blocks.compression = VtuCompression::lz4;
  else if (compressor == "vtkLZMADataCompressor") vtu.blocks.compression = VtuCompression::lzma;
  else if (!compressor.empty())
    vtu.fail(root, "compression by " + compressor + " is none of VTK's (vtkZLib-, vtkLZ4- and vtkLZMADataCompressor)");
}

}  // namespace

Place VtuFile::place(const pugi::xml_node& node) const {
  const auto offset = node.offset_debug();
  return {.file = file, .offset = static_cast<std::uint64_t>(std::max<std::ptrdiff_t>(offset, 0))};
}

void VtuFile::fail(const pugi::xml_node& node, const std::string& message) const {
  const std::string name = node.attribute("Name").value();
  const auto element = "<" + std::string(node.name()) + (name.empty() ? "" : " Name=\"" + name + "\"") + ">";
  mesh::fail(sources, place(node), element + ": " + message);
}

VtuFile open_vtu(const Sources& sources, unsigned file) {
  auto cut = cut_appended(sources, file);
  VtuFile vtu{.sources = sources, .file = file, .document = {}, .blocks = {}, .appended = cut.appended};
  // Line ends stay as they are, so that places in the document are places in the file.
  constexpr unsigned options = pugi::parse_cdata | pugi::parse_escapes | pugi::parse_wconv_attribute;
  const auto result = vtu.document.load_buffer(cut.xml.data(), cut.xml.size(), options, pugi::encoding_utf8);
  if (!result) {
    const Place place{.file = file, .offset = static_cast<std::uint64_t>(std::max<std::ptrdiff_t>(result.offset, 0))};
    fail(sources, place, std::string("the XML is wrong or truncated (") + result.description() + ")");
  }
  check_header(vtu);
  return vtu;
}

Index attribute(const VtuFile& vtu, const pugi::xml_node& node, const char* name, std::optional<Index> otherwise) {
  const auto found = node.attribute(name);
  if (!found && otherwise) return *otherwise;
  const auto text = trimmed(found.value());
  Index value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0) {
    vtu.fail(node, std::string("attribute ") + name + " must be a number that is not negative");
  }
  return value;
}

}  // namespace ritz::mesh
