#include "ritz/readers/msh_file.hpp"

#include <cmath>
#include <cstring>
#include <vector>

#include "ritz/base/error.hpp"

namespace ritz::readers {

namespace {

template <class T>
T binary(Cursor& cursor, std::string_view what) {
  T value;
  std::memcpy(&value, cursor.bytes(sizeof(T), what).data(), sizeof(T));
  return value;
}

// Whether what follows "$EndNAME" is the end of a section, and not more of its data.
bool ends_section(std::string_view after, MshEncoding encoding) {
  const auto line = after.substr(0, after.find('\n'));
  if (!trimmed(line).empty()) return false;
  if (encoding == MshEncoding::text) return true;
  const auto next = after.find_first_not_of(" \t\r\n");
  return next == after.npos || after[next] == '$';
}

// Moves past the values of $NodeData, $ElementData or $ElementNodeData in a binary file by what their tags say, and
// past the end of the section; leaves the cursor where it is when that does not lead there.
bool skip_values(Cursor& cursor, const std::string& name, const std::string& end) {
  if (name != "NodeData" && name != "ElementData" && name != "ElementNodeData") return false;
  auto here = cursor;
  try {
    for (int kind = 0; kind < 2; ++kind) {  // string tags, real tags: a line each
      Index lines = here.integer("the number of tags");
      here.line();
      for (; lines > 0 && !here.at_end(); --lines) here.line();
    }
    std::vector<Index> tags;  // time step, components, entries
    for (Index left = here.integer("the number of tags"); left > 0; --left) {
      here.skip_space();
      tags.push_back(here.integer("an integer tag"));
    }
    here.line();
    if (tags.size() < 3 || tags[1] < 1 || tags[1] > 9 || tags[2] < 0) return false;
    for (Index entry = 0; entry < tags[2]; ++entry) {
      here.bytes(4, "a number");
      const Index nodes = name == "ElementNodeData" ? binary<std::int32_t>(here, "a number of nodes") : 1;
      if (nodes < 0) return false;
      here.bytes(static_cast<std::size_t>(nodes * tags[1]) * sizeof(double), "values");
    }
    here.skip_space();
    if (here.line() != end) return false;
  } catch (const InputError&) {  // another writer's layout
    return false;
  }
  cursor = here;
  return true;
}

}  // namespace

Index MshInput::integer(std::string_view what) {
  return encoding == MshEncoding::text ? cursor.integer(what) : binary<std::int32_t>(cursor, what);
}

Index MshInput::size(std::string_view what) {
  return encoding == MshEncoding::text ? cursor.integer(what) : binary<std::int64_t>(cursor, what);
}

double MshInput::real(std::string_view what) {
  if (encoding == MshEncoding::text) return cursor.real(what);
  const auto value = binary<double>(cursor, what);
  if (!std::isfinite(value)) fail(std::string(what) + " is not a finite number");
  return value;
}

Index MshInput::count(std::string_view what, Index values) {
  const Index count = size("the number of " + std::string(what));
  check_count(count, what, values);
  return count;
}

void MshInput::check_count(Index count, std::string_view what, Index values) const {
  const Index least = values * (encoding == MshEncoding::text ? 2 : 4);  // bytes
  if (count < 0) fail("the number of " + std::string(what) + " is negative");
  if (count > static_cast<Index>(cursor.remaining()) / least + 1) {
    fail(std::to_string(count) + " " + std::string(what) +
         " cannot be in the rest of the file; it is truncated or wrong");
  }
}

void MshInput::begin_record() {
  if (encoding == MshEncoding::text) cursor.skip_space();
}

void MshInput::end_record() {
  if (encoding == MshEncoding::text) cursor.end_line();
}

void MshInput::open_binary() {
  cursor.end_line();
  if (encoding == MshEncoding::binary) cursor.line();
}

void MshInput::close_section(std::string_view name) {
  cursor.skip_space();
  const auto here = *this;
  if (cursor.line() != "$End" + std::string(name)) {
    here.fail("expected $End" + std::string(name) + " (truncated, or more entries than stated?)");
  }
}

void skip_msh_section(const Sources& sources, MshInput& input, const std::string& name, Place place) {
  auto& cursor = input.cursor;
  const std::string end = "$End" + name;
  if (input.encoding == MshEncoding::binary && skip_values(cursor, name, end)) return;
  auto rest = cursor;
  const auto bytes = rest.bytes(rest.remaining(), "a section");
  for (auto at = bytes.find(end); at != bytes.npos; at = bytes.find(end, at + 1)) {
    const auto before = bytes.substr(0, at);
    const bool begins_line = trimmed(before.substr(before.rfind('\n') + 1)).empty();
    if ((input.encoding == MshEncoding::text && !begins_line) ||
        !ends_section(bytes.substr(at + end.size()), input.encoding))
      continue;
    cursor.bytes(at, "a section");
    cursor.line();
    return;
  }
  fail(sources, place, "section $" + name + " has no end; the file is truncated");
}

}  // namespace ritz::readers
