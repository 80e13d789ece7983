// JSON values (RFC 8259), of which all summaries are written.
#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace ritz::files {

/// One JSON value. Members of an object keep their order.
class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;
  using Value = std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, Array, Object>;

  Json(std::nullptr_t) {}
  template <std::integral T>
  Json(T number) {
    if constexpr (std::same_as<T, bool>) value_ = number;
    else value_ = static_cast<std::int64_t>(number);
  }
  Json(double number) : value_(number) {}
  Json(const char* text) : value_(std::string(text)) {}
  Json(std::string_view text) : value_(std::string(text)) {}
  Json(std::string text) : value_(std::move(text)) {}
  Json(Array values) : value_(std::move(values)) {}
  Json(Object members) : value_(std::move(members)) {}
  /// null for an empty optional.
  template <class T>
  Json(const std::optional<T>& maybe) {
    if (maybe) *this = Json(*maybe);
  }

  const Value& value() const { return value_; }

 private:
  Value value_ = nullptr;
};

/// An array of the elements of a range (such as a std::vector or a column of Eigen).
template <class Range>
Json::Array json_list(const Range& range) {
  Json::Array values;
  for (const auto& element : range) values.emplace_back(element);
  return values;
}

/// The text of a value, indented, with a list of numbers or words on one line. A number is the shortest text that is
/// read back as the same double; null if it is not finite. Control characters are escaped, and a byte that is not UTF-8
/// becomes U+FFFD.
std::string json_text(const Json& value);

}  // namespace ritz::files
