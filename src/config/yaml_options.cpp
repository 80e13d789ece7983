// YAML by libyaml's events: one at a time, so that neither nesting nor length costs more than the text itself.
#include <yaml.h>

#include "ritz/base/error.hpp"
#include "ritz/config/options_text.hpp"

namespace ritz::config {
namespace {

constexpr int deepest = 16;  ///< mappings in mappings; a name of an option has fewer parts

struct Event {
  yaml_event_type_t type;
  std::size_t line;  ///< from 1
  std::string text;  ///< of a scalar
};

class YamlOptions {
 public:
  YamlOptions(const std::string& text, std::string file) : file_(std::move(file)) {
    if (!yaml_parser_initialize(&parser_)) throw std::bad_alloc();
    yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()), text.size());
  }
  ~YamlOptions() { yaml_parser_delete(&parser_); }
  YamlOptions(const YamlOptions&) = delete;
  YamlOptions& operator=(const YamlOptions&) = delete;

  std::vector<Option> read() {
    for (Event event = next(); event.type != YAML_STREAM_END_EVENT; event = next()) {
      if (event.type == YAML_MAPPING_START_EVENT) mapping("", 1);
      else if (event.type == YAML_SEQUENCE_START_EVENT || event.type == YAML_ALIAS_EVENT || !event.text.empty())
        fail(event.line, "there are options here, such as 'modes: 20', and nothing else");
    }
    return std::move(options_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& why) const {
    throw InputError(file_ + ":" + std::to_string(line) + ": " + why);
  }

  Event next() {
    yaml_event_t raw;
    if (!yaml_parser_parse(&parser_, &raw)) {
      if (parser_.error == YAML_MEMORY_ERROR) throw std::bad_alloc();
      fail(parser_.problem_mark.line + 1,
           std::string("not valid YAML: ") + (parser_.problem ? parser_.problem : "it cannot be read"));
    }
    Event event{raw.type, raw.start_mark.line + 1, {}};
    if (raw.type == YAML_SCALAR_EVENT)
      event.text.assign(reinterpret_cast<const char*>(raw.data.scalar.value), raw.data.scalar.length);
    yaml_event_delete(&raw);
    return event;
  }

  void mapping(const std::string& prefix, int depth) {
    for (Event key = next(); key.type != YAML_MAPPING_END_EVENT; key = next()) {
      if (key.type != YAML_SCALAR_EVENT) fail(key.line, "the name of an option is one word");
      if (depth > deepest) fail(key.line, "options are not nested so deeply");
      refuse_file_in_file(prefix + key.text, file_ + ":" + std::to_string(key.line));
      if (key.text.starts_with("$$")) skip(depth);
      else value(prefix + key.text, depth);
    }
  }

  void value(const std::string& name, int depth) {
    const Event event = next();
    if (event.type == YAML_SCALAR_EVENT) options_.push_back({name, event.text});
    else if (event.type == YAML_SEQUENCE_START_EVENT) options_.push_back({name, listed()});
    else if (event.type == YAML_MAPPING_START_EVENT) mapping(name + "_", depth + 1);
    else fail(event.line, "an options file has no aliases; write the value of " + name + " out");
  }

  std::string listed() {
    std::string text;
    for (Event entry = next(); entry.type != YAML_SEQUENCE_END_EVENT; entry = next()) {
      if (entry.type != YAML_SCALAR_EVENT) fail(entry.line, "a list holds words and numbers");
      text += (text.empty() ? "" : ",") + entry.text;
    }
    return text;
  }

  /// Passes over one value. libyaml itself slows down with the square of the depth.
  void skip(int depth) {
    const int outside = depth;
    do {
      const Event event = next();
      if (event.type == YAML_MAPPING_START_EVENT || event.type == YAML_SEQUENCE_START_EVENT) ++depth;
      if (event.type == YAML_MAPPING_END_EVENT || event.type == YAML_SEQUENCE_END_EVENT) --depth;
      if (depth > deepest) fail(event.line, "options are not nested so deeply");
    } while (depth > outside);
  }

  std::string file_;
  yaml_parser_t parser_;
  std::vector<Option> options_;
};

}  // namespace

std::vector<Option> parse_yaml_options(const std::string& text, const std::string& file) {
  return YamlOptions(text, file).read();
}

}  // namespace ritz::config
