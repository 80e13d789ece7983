#include "ritz/mesh/read_lines.hpp"

#include <system_error>

#include "ritz/base/error.hpp"

namespace ritz::mesh {

Lines::Lines(Sources& sources, unsigned file) : sources_(&sources), stack_{Cursor(sources, file)} {}

std::optional<Line> Lines::next() {
  while (!stack_.empty() && stack_.back().at_end()) stack_.pop_back();
  if (stack_.empty()) return std::nullopt;
  auto place = stack_.back().place();
  const auto text = stack_.back().line();
  const auto begin = (*sources_)[place.file].bytes.data();
  if (!text.empty()) place.offset = static_cast<std::uint64_t>(text.data() - begin);
  return Line{.place = place, .text = text};
}

void Lines::include(std::string_view name, Place at) {
  if (name.empty()) fail(at, "*INCLUDE names no file");
  const auto path = (*sources_)[at.file].path.parent_path() / name;
  for (const auto& open : stack_) {
    std::error_code error;
    if (std::filesystem::equivalent((*sources_)[open.place().file].path, path, error)) {
      fail(at, "'" + std::string(name) + "' includes itself");
    }
  }
  try {
    stack_.emplace_back(*sources_, open(*sources_, path));
  } catch (const InputError& error) {
    fail(at, std::string("cannot include ") + error.what());
  }
}

}  // namespace ritz::mesh
