#include "ritz/mesh/read_vtu_array.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace ritz::mesh {
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

}  // namespace ritz::mesh
