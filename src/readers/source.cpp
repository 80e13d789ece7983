#include "ritz/readers/source.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <system_error>

#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"

namespace ritz::readers {

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

std::string ignored_word(std::string_view text) {
  std::string word = upper(text);
  std::erase_if(word, [](char c) { return c == ' ' || c == '*'; });
  return word;
}

namespace {

bool blank(char c) { return c == ' ' || c == ',' || c == '\t' || c == '\r'; }

}  // namespace

Cursor::Cursor(const Sources& sources, unsigned file)
    : Cursor(sources, {.file = file, .offset = 0}, sources[file].bytes.size()) {}

Cursor::Cursor(const Sources& sources, Place begin, std::size_t length)
    : sources_(&sources),
      data_(sources[begin.file].bytes.data()),
      position_(begin.offset),
      end_(begin.offset + length),
      file_(begin.file) {}

void Cursor::skip_blanks() {
  while (position_ < end_ && blank(data_[position_])) ++position_;
}

void Cursor::skip_space() {
  while (position_ < end_ && (blank(data_[position_]) || data_[position_] == '\n')) ++position_;
}

bool Cursor::line_ends() {
  skip_blanks();
  return at_end() || data_[position_] == '\n';
}

void Cursor::end_line() {
  if (!line_ends()) fail("expected the end of the line, found '" + std::string(token()) + "'");
}

std::string_view Cursor::line() {
  const std::string_view rest(data_ + position_, remaining());
  const auto length = std::min(rest.find('\n'), rest.size());
  position_ += std::min(length + 1, rest.size());
  return trimmed(rest.substr(0, length));
}

std::string_view Cursor::bytes(std::size_t count, std::string_view what) {
  if (count > remaining()) fail("the file ends inside " + std::string(what) + "; it is truncated");
  const std::string_view result(data_ + position_, count);
  position_ += count;
  return result;
}

Index Cursor::integer(std::string_view what) {
  skip_blanks();
  const char* first = data_ + position_;
  if (!at_end() && *first == '+') ++first;
  Index value = 0;
  const auto [next, error] = std::from_chars(first, data_ + end_, value);
  const bool lowest = value == std::numeric_limits<Index>::min();  // the one number without an opposite
  if (error == std::errc::result_out_of_range || lowest) fail(std::string(what) + ": the number is too large");
  if (error != std::errc() || !separates(next)) unexpected(what);
  position_ = static_cast<std::size_t>(next - data_);
  return value;
}

double Cursor::real(std::string_view what) {
  skip_blanks();
  const char* first = data_ + position_;
  if (!at_end() && *first == '+') ++first;
  double value = 0;
  const auto [next, error] = std::from_chars(first, data_ + end_, value);
  if (error != std::errc() || !separates(next)) return unusual_real(what);
  if (!std::isfinite(value)) fail(std::string(what) + " is not a finite number");
  position_ = static_cast<std::size_t>(next - data_);
  return value;
}

// Fortran's exponents (1.5D+03) and numbers below the smallest double.
double Cursor::unusual_real(std::string_view what) {
  std::string text(token());
  if (text.starts_with('+')) text.erase(0, 1);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
  double value = 0;
  const auto [next, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (next != text.data() + text.size() || error == std::errc::invalid_argument) unexpected(what);
  const bool overflow = error != std::errc() && text.find("e-") == std::string::npos;
  if (overflow || !std::isfinite(value)) fail(std::string(what) + " is not a finite number");
  position_ += token().size();
  return error == std::errc() ? value : 0.0;
}

bool Cursor::separates(const char* next) const { return next == data_ + end_ || blank(*next) || *next == '\n'; }

std::string_view Cursor::token() const {
  auto last = position_;
  while (!separates(data_ + last)) ++last;
  return {data_ + position_, last - position_};
}

void Cursor::unexpected(std::string_view what) const {
  std::string found(token().substr(0, 24));
  if (found.empty())
    found = at_end() && end_ == (*sources_)[file_].bytes.size() ? "the end of the file" : "the end of the line";
  else found = "'" + found + "'";
  fail("expected " + std::string(what) + ", found " + found);
}

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

}  // namespace ritz::readers
