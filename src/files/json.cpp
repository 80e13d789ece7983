#include "ritz/files/json.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "ritz/base/printable.hpp"

namespace ritz::files {
namespace {

std::string number_text(double number) {
  if (!std::isfinite(number)) return "null";
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), end};
}

std::string string_text(std::string_view text) {
  std::string escaped = "\"";
  while (!text.empty()) {
    const auto length = utf8_length(text);
    const auto first = static_cast<unsigned char>(text[0]);
    if (length == 0) escaped += "\\ufffd";
    else if (first < 0x20 || first == 0x7f) {
      std::array<char, 8> code{};
      std::snprintf(code.data(), code.size(), "\\u%04x", static_cast<unsigned>(first));
      escaped += code.data();
    } else {
      if (first == '"' || first == '\\') escaped += '\\';
      escaped += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return escaped + '"';
}

/// Appends values to a text, each with the indentation of what it stands in.
struct Writer {
  std::string text = {};
  std::string indentation = {};

  void operator()(std::nullptr_t) { text += "null"; }
  void operator()(bool truth) { text += truth ? "true" : "false"; }
  void operator()(std::int64_t number) { text += std::to_string(number); }
  void operator()(double number) { text += number_text(number); }
  void operator()(const std::string& words) { text += string_text(words); }

  void operator()(const Json::Array& values) {
    const auto nested = [](const Json& value) {
      return std::holds_alternative<Json::Array>(value.value()) || std::holds_alternative<Json::Object>(value.value());
    };
    if (std::ranges::any_of(values, nested))
      return block(values, '[', ']', [&](const Json& value) { std::visit(*this, value.value()); });
    text += '[';
    for (const char* between = ""; const auto& value : values) {
      text += between;
      std::visit(*this, value.value());
      between = ", ";
    }
    text += ']';
  }

  void operator()(const Json::Object& members) {
    if (members.empty()) text += "{}";
    else
      block(members, '{', '}', [&](const auto& member) {
        text += string_text(member.first) + ": ";
        std::visit(*this, member.second.value());
      });
  }

 private:
  /// One element a line.
  template <class Elements, class Write>
  void block(const Elements& elements, char begin, char end, Write write) {
    text += begin;
    indentation += "  ";
    for (const char* between = "\n"; const auto& element : elements) {
      text += between + indentation;
      write(element);
      between = ",\n";
    }
    indentation.resize(indentation.size() - 2);
    text += '\n' + indentation + end;
  }
};

}  // namespace

std::string json_text(const Json& value) {
  Writer writer;
  std::visit(writer, value.value());
  return writer.text + '\n';
}

}  // namespace ritz::files
