#include "ritz/mesh/read_msh_input.hpp"

#include <cmath>
#include <cstring>

namespace ritz::mesh {
namespace {

template <class T>
T binary(Cursor& cursor, std::string_view what) {
  T value;
  std::memcpy(&value, cursor.bytes(sizeof(T), what).data(), sizeof(T));
  return value;
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

}  // namespace ritz::mesh
