#include "ritz/format/names.hpp"

#include <algorithm>
#include <array>

namespace ritz::format {

namespace {

constexpr std::array<std::string_view, 2> rows_names = {"all", "surface"};
constexpr std::array<std::string_view, 2> kind_names = {"rigid", "flexible"};
constexpr std::array<std::string_view, 4> certified_names = {"no", "probabilistic", "inertia-f32", "inertia"};
constexpr std::array<std::string_view, 2> integrand_names = {"energy", "beyond-polynomial"};
constexpr std::array<std::string_view, 2> state_names = {"at_rest", "moving"};

template <class Names, class Enum>
bool find(const Names& names, std::string_view text, Enum& value) {
  const auto at = std::ranges::find(names, text);
  if (at == names.end()) return false;
  value = static_cast<Enum>(at - names.begin());
  return true;
}

}  // namespace

std::string_view name(model::Rows rows) { return rows_names[static_cast<std::size_t>(rows)]; }
std::string_view name(model::ModeKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }
std::string_view name(model::Certified certified) { return certified_names[static_cast<std::size_t>(certified)]; }
std::string_view name(model::Integrand integrand) { return integrand_names[static_cast<std::size_t>(integrand)]; }
std::string_view name(StateKind kind) { return state_names[static_cast<std::size_t>(kind)]; }

bool parse(std::string_view text, model::Rows& rows) { return find(rows_names, text, rows); }
bool parse(std::string_view text, model::ModeKind& kind) { return find(kind_names, text, kind); }
bool parse(std::string_view text, model::Certified& certified) { return find(certified_names, text, certified); }
bool parse(std::string_view text, model::Integrand& integrand) { return find(integrand_names, text, integrand); }
bool parse(std::string_view text, StateKind& kind) { return find(state_names, text, kind); }

}  // namespace ritz::format
