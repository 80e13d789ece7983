#include "ritz/mesh/dofs.hpp"

#include <algorithm>

#include "ritz/algebra/check.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/random.hpp"
#include "ritz/base/set_name.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::mesh {
namespace {

/// A name as -fix takes it for that name and nothing else.
std::string written(const std::string& name) {
  const auto colon = name.rfind(':');
  const bool components = colon != name.npos && name.find_first_not_of("xyz", colon + 1) == name.npos;
  const bool plain = name.find(',') == name.npos && !components && name != "none" && !name.starts_with("box:");
  return plain ? name : '"' + name + '"';
}

/// What a word of -fix names, and the components that it holds there.
struct Held {
  const Set& set;
  std::array<bool, components> fixed;
};

Held held_set(const Mesh& mesh, const Fixed& support) {
  const auto& name = std::get<std::string>(support.where);
  std::vector<std::string> names;
  for (const auto& set : mesh.sets) names.push_back(set.name);
  std::string where = "option -fix " + support.text + ": ";
  if (names.empty()) throw InputError(where + "the mesh has no named sets; use box:x0,x1,y0,y1,z0,z1");
  const bool short_name = !meant_sets(names, name, SetUse::vertices).empty();
  if (support.whole_name && !meant_sets(names, *support.whole_name, SetUse::vertices).empty()) {
    const auto& whole = *support.whole_name;
    if (short_name)
      throw InputError(where + "the mesh has a set '" + name + "' and a set '" + whole + "'; write '\"" + name + "\"" +
                       whole.substr(name.size()) + "' for components of the one or '" + written(whole) +
                       "' for the other");
    return {*mesh.find(resolve_set(names, whole, SetUse::vertices, where + "the mesh", written)), {true, true, true}};
  }
  if (!short_name && support.text != name && !meant_sets(names, support.text, SetUse::vertices).empty())
    throw InputError(where + "the mesh has a set of this whole name; write it in double quotes, '" +
                     written(support.text) + "'");
  const auto colon = name.rfind(':');
  if (!short_name && colon != name.npos && !support.whole_name)
    where += "'" + name.substr(colon + 1) + "' are no components (some of xyz), and ";
  return {*mesh.find(resolve_set(names, name, SetUse::vertices, where + "the mesh", written)), support.fixed};
}

std::vector<int> inside(const Mesh& mesh, const Region3& box, const std::string& text) {
  std::vector<int> inside;
  Index owned = 0;
  for (int v = 0; v < mesh.local_vertices(); ++v) {
    const auto x = mesh.points.col(v).array();
    if ((x < box.low.array()).any() || (x > box.high.array()).any()) continue;
    inside.push_back(v);
    owned += v < mesh.owned;
  }
  if (parallel::sum(mesh.comm, owned) == 0) throw InputError("option -fix " + text + ": no vertex lies in that box");
  return inside;
}

void fix(Mask& mask, const std::vector<int>& vertices, const std::array<bool, components>& which) {
  for (const int v : vertices)
    for (std::size_t c = 0; c < components; ++c)
      if (which[c]) mask[components * static_cast<std::size_t>(v) + c] = 1;
}

void fix(const Mesh& mesh, const Fixed& support, Mask& mask) {
  if (const auto* box = std::get_if<Region3>(&support.where)) {
    fix(mask, inside(mesh, *box, support.text), support.fixed);
    return;
  }
  const auto [set, fixed] = held_set(mesh, support);
  if (set.vertices_total == 0)
    throw InputError("option -fix " + support.text + ": the set '" + set.name + "' is empty");
  fix(mask, set.vertices, fixed);
}

/// Numbers owned free components from dofs.first on; then asks the owners of ghosts.
void number_owned(const Mesh& mesh, const Mask& mask, Dofs& dofs) {
  dofs.numbers.assign(components * static_cast<std::size_t>(mesh.local_vertices()), -1);
  Index free = 0;
  for (std::size_t i = 0; i < components * static_cast<std::size_t>(mesh.owned); ++i) free += !mask[i];
  dofs.owned = static_cast<int>(free);
  dofs.first = parallel::sum_before(mesh.comm, free);
  dofs.total = parallel::sum(mesh.comm, free);
  Index next = dofs.first;
  for (std::size_t i = 0; i < components * static_cast<std::size_t>(mesh.owned); ++i)
    if (!mask[i]) dofs.numbers[i] = next++;
}

void number_ghosts(const Mesh& mesh, Dofs& dofs) {
  const auto firsts = parallel::gather_all(mesh.comm, std::vector<Index>{mesh.first});
  const auto ranks = firsts.size();
  std::vector<std::vector<Index>> asked(ranks);
  std::vector<std::size_t> owner(static_cast<std::size_t>(mesh.local_vertices() - mesh.owned));
  for (std::size_t g = 0; g < owner.size(); ++g) {
    const Index vertex = mesh.global[static_cast<std::size_t>(mesh.owned) + g];
    owner[g] = static_cast<std::size_t>(std::upper_bound(firsts.begin(), firsts.end(), vertex) - firsts.begin() - 1);
    asked[owner[g]].push_back(vertex);
  }
  auto answers = parallel::exchange(mesh.comm, asked);
  for (auto& list : answers) {
    std::vector<Index> numbers;
    for (const Index vertex : list)
      for (int c = 0; c < components; ++c) numbers.push_back(dofs.number(static_cast<int>(vertex - mesh.first), c));
    list = std::move(numbers);
  }
  answers = parallel::exchange(mesh.comm, answers);
  std::vector<std::size_t> next(ranks, 0);
  for (std::size_t g = 0; g < owner.size(); ++g)
    for (std::size_t c = 0; c < components; ++c)
      dofs.numbers[components * (static_cast<std::size_t>(mesh.owned) + g) + c] = answers[owner[g]][next[owner[g]]++];
}

[[noreturn]] void refuse_all_fixed(const std::vector<Fixed>& supports) {
  if (supports.empty())
    throw InputError(
        "the mesh file's own supports (*BOUNDARY) fix every vertex of the mesh: nothing is left to move; -fix replaces "
        "them");
  throw InputError("the supports (-fix) fix every vertex of the mesh: nothing is left to move");
}

}  // namespace

Dofs number(const Mesh& mesh, const std::vector<Fixed>& supports, FileSupports file_supports) {
  Mask mask(components * static_cast<std::size_t>(mesh.local_vertices()), 0);
  for (const auto& support : supports) fix(mesh, support, mask);
  if (file_supports == FileSupports::used)
    for (const auto& support : mesh.supports) fix(mask, support.vertices, support.held);
  Dofs dofs = number_free(mesh, mask);
  if (dofs.total == 0) refuse_all_fixed(supports);
  return dofs;
}

Dofs number_free(const Mesh& mesh, const Mask& fixed) {
  Dofs dofs;
  dofs.comm = mesh.comm;
  number_owned(mesh, fixed, dofs);
  algebra::refuse_beyond_index("the mesh has " + std::to_string(dofs.total) + " degrees of freedom", dofs.total);
  number_ghosts(mesh, dofs);

  std::int32_t partly = 0;
  std::uint64_t sum = 0;
  for (std::size_t v = 0; v < static_cast<std::size_t>(mesh.owned); ++v) {
    const int held = fixed[3 * v] + 2 * fixed[3 * v + 1] + 4 * fixed[3 * v + 2];
    partly |= held != 0 && held != 7;
    if (held)
      sum += split_mix(static_cast<std::uint64_t>(mesh.file_positions[v]) * 8 + static_cast<std::uint64_t>(held));
  }
  dofs.block = parallel::max(mesh.comm, partly) ? 1 : components;
  dofs.checksum = parallel::sum(mesh.comm, sum);
  return dofs;
}

VertexRows to_vertices(const Mesh& mesh, const Dofs& dofs, FreeRef x) {
  VertexRows u = VertexRows::Zero(components * mesh.owned, x.cols());
  for (int v = 0; v < mesh.owned; ++v)
    for (int c = 0; c < components; ++c)
      if (!dofs.fixed(v, c)) u.row(components * v + c) = x.row(dofs.number(v, c) - dofs.first);
  return u;
}

FreeRows from_vertices(const Mesh& mesh, const Dofs& dofs, VertexRef u) {
  FreeRows x(dofs.owned, u.cols());
  for (int v = 0; v < mesh.owned; ++v)
    for (int c = 0; c < components; ++c)
      if (!dofs.fixed(v, c)) x.row(dofs.number(v, c) - dofs.first) = u.row(components * v + c);
  return x;
}

}  // namespace ritz::mesh
