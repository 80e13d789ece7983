#include "ritz/mesh/read_source.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"

namespace ritz::mesh {

namespace {

// A mesh file may include any file that the user can read; a message shows nothing that stands in quotes of such a
// file, except what it tells the user to say.
std::string without_quotes(const std::string& message) {
  std::string result;
  for (std::size_t at = 0; at < message.size();) {
    const auto begin = message.find('\'', at);
    const auto end = begin == message.npos ? message.npos : message.find('\'', begin + 1);
    result += message.substr(at, begin == message.npos ? begin : begin - at);
    if (begin == message.npos) break;
    const auto quoted = message.substr(begin, end == message.npos ? end : end + 1 - begin);
    result += quoted.starts_with("'-ignore ") ? quoted : "'...'";
    at = end == message.npos ? message.size() : end + 1;
  }
  return result;
}

}  // namespace

unsigned open(Sources& sources, const std::filesystem::path& path) {
  const auto refuse = [&](const char* why) { throw InputError(path.string() + ": " + why); };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) refuse("no such file");
  if (std::filesystem::is_directory(status)) refuse("is a directory, not a file");
  if (!std::filesystem::is_regular_file(status)) refuse("is not a regular file");
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) refuse("cannot be read; check its permissions");
  SourceFile source{.path = path, .bytes = std::string(size, '\0')};
  if (!stream.read(source.bytes.data(), static_cast<std::streamsize>(size))) refuse("cannot be read to its end");
  if (source.bytes.starts_with("\xEF\xBB\xBF")) source.bytes.erase(0, 3);  // UTF-8's mark, as Windows editors write it
  if (source.bytes.empty()) refuse("is empty");
  if (sources.size() == 255) refuse("too many included files");
  sources.push_back(std::move(source));
  return static_cast<unsigned>(sources.size() - 1);
}

std::string located(const Sources& sources, Place place) {
  const auto& source = sources[place.file];
  const auto name = source.path.string();
  if (source.counting == Counting::bytes) return name + ", byte " + std::to_string(place.offset) + ": ";
  const auto begin = source.bytes.begin();
  const auto offset = std::min<std::size_t>(place.offset, source.bytes.size());
  const auto line = 1 + std::count(begin, begin + static_cast<std::ptrdiff_t>(offset), '\n');
  return name + ":" + std::to_string(line) + ": ";
}

void fail(const Sources& sources, Place place, const std::string& message) {
  throw InputError(located(sources, place) + printable(place.file == 0 ? message : without_quotes(message)));
}

void fail(const Sources& sources, const std::string& message) {
  throw InputError(sources.front().path.string() + ": " + printable(message));
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return result;
}

}  // namespace ritz::mesh
