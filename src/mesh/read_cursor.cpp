#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "ritz/mesh/read_source.hpp"

namespace ritz::mesh {
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

}  // namespace ritz::mesh
