#include "ritz/readers/units.hpp"

#include <array>
#include <utility>

#include "ritz/base/error.hpp"

namespace ritz::readers {
namespace {

using Table = std::initializer_list<std::pair<std::string_view, double>>;

double look_up(const Table& table, std::string_view word, std::string_view text) {
  for (const auto& [name, value] : table)
    if (name == word) return value;
  throw InputError("option -units " + std::string(text) + ": '" + std::string(word) +
                   "' is no known unit; write length-mass-time such as m-kg-s, mm-t-s or um-kg-s");
}

}  // namespace

Units parse_units(std::string_view text) {
  const auto first = text.find('-');
  const auto second = first == text.npos ? text.npos : text.find('-', first + 1);
  if (second == text.npos)
    throw InputError("option -units " + std::string(text) +
                     " is not of the form length-mass-time; write for instance m-kg-s, mm-t-s or um-kg-s");
  const Table lengths = {{"m", 1},     {"dm", 0.1}, {"cm", 0.01},   {"mm", 1e-3},  {"um", 1e-6},
                         {"nm", 1e-9}, {"km", 1e3}, {"in", 0.0254}, {"ft", 0.3048}};
  const Table masses = {{"kg", 1}, {"t", 1e3}, {"g", 1e-3}, {"mg", 1e-6}, {"ug", 1e-9}, {"pg", 1e-15}};
  const Table times = {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};
  return {std::string(text), look_up(lengths, text.substr(0, first), text),
          look_up(masses, text.substr(first + 1, second - first - 1), text),
          look_up(times, text.substr(second + 1), text)};
}

}  // namespace ritz::readers
