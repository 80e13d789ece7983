#include "ritz/readers/vtu_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

namespace ritz::readers {

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
  readers::fail(sources, place(node), element + ": " + message);
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

namespace {

std::string type_of(const pugi::xml_node& array) { return array.attribute("type").value(); }

template <class From, class To>
std::vector<To> converted(const VtuFile& vtu, const pugi::xml_node& array, const std::string& bytes, Index count) {
  if (bytes.size() % sizeof(From) != 0 || bytes.size() / sizeof(From) != static_cast<std::uint64_t>(count)) {
    vtu.fail(array, "the array holds " + std::to_string(bytes.size() / sizeof(From)) + " numbers instead of " +
                        std::to_string(count));
  }
  std::vector<To> values(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::array<char, sizeof(From)> raw;
    std::copy_n(bytes.data() + i * sizeof(From), sizeof(From), raw.begin());
    if (vtu.blocks.order == VtuOrder::big) std::reverse(raw.begin(), raw.end());
    const auto value = std::bit_cast<From>(raw);
    if constexpr (std::is_same_v<From, std::uint64_t>) {
      if (value > std::numeric_limits<Index>::max()) vtu.fail(array, "a number is too large");
    }
    values[i] = static_cast<To>(value);
  }
  return values;
}

std::string binary_bytes(const VtuFile& vtu, const pugi::xml_node& array) {
  if (array.attribute("format").as_string() != std::string("appended")) {
    const VtuText data{.text = array.child_value(), .encoding = VtuEncoding::base64, .place = vtu.place(array)};
    return decode(vtu.sources, data, vtu.blocks);
  }
  if (!vtu.appended) vtu.fail(array, "the data is said to be appended, but the file has no <AppendedData>");
  const Index offset = attribute(vtu, array, "offset");
  auto data = *vtu.appended;
  if (offset > static_cast<Index>(data.text.size())) vtu.fail(array, "the offset lies beyond the end of the file");
  data.text.remove_prefix(static_cast<std::size_t>(offset));
  data.place = vtu.place(array);
  return decode(vtu.sources, data, vtu.blocks);
}

template <class Read>
auto text_values(const VtuFile& vtu, const pugi::xml_node& array, Index count, Read read) {
  const auto text = array.first_child();
  const std::string_view content = text.value();
  auto place = vtu.place(text ? text : array);
  Cursor cursor(vtu.sources, place, content.size());
  std::vector<decltype(read(cursor))> values;
  for (cursor.skip_space(); !cursor.at_end(); cursor.skip_space()) values.push_back(read(cursor));
  if (static_cast<Index>(values.size()) != count) {
    vtu.fail(array,
             "the array holds " + std::to_string(values.size()) + " numbers instead of " + std::to_string(count));
  }
  return values;
}

bool is_text(const VtuFile& vtu, const pugi::xml_node& array) {
  const std::string format = array.attribute("format").as_string("ascii");
  if (format != "ascii" && format != "binary" && format != "appended") {
    vtu.fail(array, "format '" + format + "' is not ascii, binary or appended");
  }
  return format == "ascii";
}

}  // namespace

bool is_integer(const pugi::xml_node& array) {
  const auto type = type_of(array);
  return type.starts_with("Int") || type.starts_with("UInt");
}

bool is_byte(const pugi::xml_node& array) { return type_of(array) == "Int8" || type_of(array) == "UInt8"; }

std::vector<double> reals(const VtuFile& vtu, const pugi::xml_node& array, Index count) {
  const auto type = type_of(array);
  if (type != "Float32" && type != "Float64") vtu.fail(array, "type '" + type + "' is not Float32 or Float64");
  if (is_text(vtu, array)) {
    return text_values(vtu, array, count, [](Cursor& cursor) { return cursor.real("a coordinate"); });
  }
  const auto bytes = binary_bytes(vtu, array);
  const auto values = type == "Float32" ? converted<float, double>(vtu, array, bytes, count)
                                        : converted<double, double>(vtu, array, bytes, count);
  for (const double value : values) {
    if (!std::isfinite(value)) vtu.fail(array, "a number is not finite");
  }
  return values;
}

std::vector<Index> integers(const VtuFile& vtu, const pugi::xml_node& array, Index count) {
  const auto type = type_of(array);
  if (is_integer(array) && is_text(vtu, array)) {
    return text_values(vtu, array, count, [](Cursor& cursor) { return cursor.integer("an integer"); });
  }
  const auto bytes = is_integer(array) ? binary_bytes(vtu, array) : std::string();
  if (type == "Int8") return converted<std::int8_t, Index>(vtu, array, bytes, count);
  if (type == "UInt8") return converted<std::uint8_t, Index>(vtu, array, bytes, count);
  if (type == "Int16") return converted<std::int16_t, Index>(vtu, array, bytes, count);
  if (type == "UInt16") return converted<std::uint16_t, Index>(vtu, array, bytes, count);
  if (type == "Int32") return converted<std::int32_t, Index>(vtu, array, bytes, count);
  if (type == "UInt32") return converted<std::uint32_t, Index>(vtu, array, bytes, count);
  if (type == "Int64") return converted<std::int64_t, Index>(vtu, array, bytes, count);
  if (type == "UInt64") return converted<std::uint64_t, Index>(vtu, array, bytes, count);
  vtu.fail(array, "type '" + type + "' is not an integer type");
}

}  // namespace ritz::readers
