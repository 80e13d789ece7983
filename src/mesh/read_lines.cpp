#include "ritz/mesh/read_lines.hpp"

#include <algorithm>
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

// A file that is included again stays in memory once; what is read again is in proportion to what there is.
std::optional<unsigned> Lines::included_before(const std::filesystem::path& path, Place at) {
  if (++includes_ > 1000) fail(at, "more than 1000 files are included, one inside another or again and again");
  const auto found =
      std::find_if(sources_->begin(), sources_->end(), [&](const auto& source) { return source.path == path; });
  if (found == sources_->end()) return std::nullopt;
  std::size_t bytes = 0;
  for (const auto& source : *sources_) bytes += source.bytes.size();
  repeated_bytes_ += found->bytes.size();
  if (repeated_bytes_ > 16 * bytes + (std::size_t{1} << 24))
    fail(at, "the files that are included again and again are out of proportion to what they hold; include each once");
  return static_cast<unsigned>(found - sources_->begin());
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
  const auto before = included_before(path, at);
  try {
    stack_.emplace_back(*sources_, before ? *before : open(*sources_, path));
  } catch (const InputError& error) {
    fail(at, std::string("cannot include ") + error.what());
  }
}

}  // namespace ritz::mesh
