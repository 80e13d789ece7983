// Resolves the name of a set where a mesh file gives the same name to sets of several kinds.
#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"

namespace ritz {

/// What a set is used for.
enum class SetUse {
  vertices,  ///< supports, forces shared by vertices, probes; as Abaqus's *BOUNDARY, *CLOAD and *NODE PRINT
  surface    ///< pressure and traction: as *DSLOAD
};

/// The kinds that distinguish sets of the same name: "KIND:NAME". Abaqus has nset, elset and surface; point, curve,
/// surface and volume are the dimensions of Gmsh's physical groups and VTK's cells; points are VTK's point arrays.
inline constexpr std::array<std::string_view, 7> set_kinds = {"nset",  "points",  "elset", "point",
                                                              "curve", "surface", "volume"};

/// "KIND:NAME".
inline std::string of_kind(std::string_view kind, std::string_view name) {
  return std::string(kind) + ':' + std::string(name);
}

/// "'a', 'b' or 'c'".
inline std::string listed_names(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "'" : i + 1 < names.size() ? ", '" : " or '") + names[i] + "'";
  return text;
}

/// The sets that `asked` may mean: the set of exactly this name; or else, of the sets "KIND:asked", those whose kind
/// fits the use best. Empty when there is none.
inline std::vector<std::string> meant_sets(const std::vector<std::string>& names, const std::string& asked,
                                           SetUse use) {
  const auto has = [&](const std::string& name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  if (has(asked)) return {asked};
  std::vector<std::string> meant;
  for (const auto kind : set_kinds) {
    const auto name = of_kind(kind, asked);
    if (!has(name)) continue;
    const bool first = use == SetUse::surface ? kind == "surface" : kind == "nset" || kind == "points";
    if (first) return {name};
    meant.push_back(name);
  }
  // A support or a load is not put on the whole body when a part of its boundary has the same name.
  if (meant.size() > 1 && meant.back() == of_kind("volume", asked)) meant.pop_back();
  return meant;
}

/// All names, and the names of "KIND:NAME" without their kind: with these a misspelt name is compared.
inline std::vector<std::string> with_plain_names(std::vector<std::string> names) {
  for (std::size_t i = 0, n = names.size(); i < n; ++i)
    for (const auto kind : set_kinds)
      if (names[i].starts_with(of_kind(kind, ""))) names.push_back(names[i].substr(kind.size() + 1));
  return names;
}

/// How a name is written in the place where the user gave it.
using Written = std::string (*)(const std::string& name);
inline std::string as_it_is(const std::string& name) { return name; }

/// The name of the set that `asked` means for this use. Throws an InputError that begins with `where` (such as "option
/// -fix FIX: the mesh"): it names the sets that may have been meant when there is none, and lists the sets when several
/// remain.
inline std::string resolve_set(const std::vector<std::string>& names, const std::string& asked, SetUse use,
                               const std::string& where, Written written = as_it_is) {
  auto meant = meant_sets(names, asked, use);
  if (meant.size() == 1) return meant[0];
  for (auto& name : meant) name = written(name);
  if (meant.size() > 1)
    throw InputError(where + " has several sets '" + asked + "'; say which: " + listed_names(meant));
  if (names.empty()) throw InputError(where + " has no set '" + asked + "'; it has no named sets");
  const auto colon = asked.find(':');
  const auto kind = std::string_view(asked).substr(0, colon);
  const bool kind_said = colon != asked.npos && std::find(set_kinds.begin(), set_kinds.end(), kind) != set_kinds.end();
  const auto plain = kind_said ? asked.substr(colon + 1) : asked;
  if (kind_said && std::find(names.begin(), names.end(), plain) != names.end())
    throw InputError(where + " has one set alone of that name; write '" + written(plain) + "'");
  const auto known = with_plain_names(names);
  const auto word = meant_by(asked, known).empty() ? asked.substr(0, asked.rfind(':')) : asked;  // NAME:components
  throw InputError(where + " has no set '" + asked + "'" +
                   hint(word, known, [&](const std::string& name) { return "'" + written(name) + "'"; }));
}

}  // namespace ritz
