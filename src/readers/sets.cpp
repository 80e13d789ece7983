#include "ritz/readers/listed.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "ritz/base/set_name.hpp"
#include "ritz/base/shown.hpp"

namespace ritz::readers {

namespace {

FaceCell face_cell(fem::FaceType type, std::span<const Index> vertices) {
  FaceCell face{.type = type, .vertices = {}};
  std::copy(vertices.begin(), vertices.end(), face.vertices.begin());
  return face;
}

FaceCell face_of(const ListedMesh& mesh, const ListedFace& where) {
  const auto& side = fem::side(*mesh.shapes[static_cast<std::size_t>(where.cell)].cell, where.face);
  const auto cell = mesh.vertices_of(where.cell);
  std::vector<Index> vertices;
  for (const int local : side.vertices()) vertices.push_back(cell[static_cast<std::size_t>(local)]);
  return face_cell(side.type, vertices);
}

// A listed cell of dimension 2 as a face; none where its corners span no area. A quadrilateral with two corners in one
// vertex is a triangle.
std::optional<FaceCell> spanned_face(fem::FaceType type, std::span<const Index> vertices) {
  const auto corners = vertices.first(static_cast<std::size_t>(fem::shape(type).corners));
  std::vector<Index> distinct;
  for (const Index v : corners)
    if (std::find(distinct.begin(), distinct.end(), v) == distinct.end()) distinct.push_back(v);
  if (distinct.size() == corners.size()) return face_cell(type, vertices);
  if (fem::shape(type).corners != 4 || distinct.size() != 3) return std::nullopt;
  return face_cell(fem::FaceType::tri3, distinct);
}

// Each face once, also when two parts of a union list it.
std::vector<FaceCell> faces_of(const ListedMesh& mesh, const ListedSet& set) {
  std::vector<FaceCell> faces;
  std::set<std::vector<Index>> seen;
  const auto add = [&](const FaceCell& face) {
    std::vector<Index> key(face.vertices.begin(), face.vertices.begin() + fem::shape(face.type).vertices);
    std::sort(key.begin(), key.end());
    if (seen.insert(key).second) faces.push_back(face);
  };
  for (const Index cell : set.cells) {
    const auto type = mesh.shapes[static_cast<std::size_t>(cell)].face;
    if (!type) continue;
    if (const auto face = spanned_face(*type, mesh.vertices_of(cell))) add(*face);
  }
  for (const auto& face : set.faces) add(face_of(mesh, face));
  return faces;
}

bool is_empty(const ListedSet& set) { return set.vertices.empty() && set.cells.empty() && set.faces.empty(); }

// "'FIX' names several sets: 'nset:FIX' or 'elset:FIX'; ...". `shared` is not empty.
std::string shared_note(const std::vector<std::string>& names, const std::vector<std::string>& shared) {
  const auto& name = shared.front();
  std::vector<std::string> kinds;
  for (const auto kind : set_kinds)
    if (std::find(names.begin(), names.end(), of_kind(kind, name)) != names.end()) kinds.push_back(of_kind(kind, name));
  const auto meaning = [&](SetUse use) {
    const auto meant = meant_sets(names, name, use);
    return meant.size() == 1 ? "means '" + meant[0] + "'" : std::string("is not clear");
  };
  const auto others = std::ssize(shared) - 1;
  return "'" + name + "' names several sets, " + listed_names(kinds) + "; the name alone " + meaning(SetUse::vertices) +
         " to supports, forces and probes, and " + meaning(SetUse::surface) + " to pressure and traction" +
         (others > 0 ? " (and so on for " + counted(others, "other name", "other names") + ")" : "");
}

}  // namespace

void tell_kinds_apart(const Sources& sources, ListedMesh& mesh) {
  std::map<std::string, std::set<std::string_view>> kinds;
  for (const auto& set : mesh.sets)
    if (!is_empty(set)) kinds[set.name].insert(set.kind);
  std::vector<std::string> names, shared;
  for (auto& set : mesh.sets) {
    if (is_empty(set)) continue;
    if (kinds[set.name].size() > 1) {
      if (std::find(shared.begin(), shared.end(), set.name) == shared.end()) shared.push_back(set.name);
      set.name = of_kind(set.kind, set.name);
    }
    names.push_back(set.name);
  }
  auto sorted = names;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    fail(sources, "the set '" + *twice + "' has the name by which another is told apart; rename it");
  if (!shared.empty()) mesh.notes.push_back(sources.front().path.string() + ": " + shared_note(names, shared));
}

std::vector<NamedSet> gather_sets(const ListedMesh& mesh) {
  std::vector<NamedSet> sets;
  std::vector<std::size_t> last_set(mesh.points.size(), 0);  // 1 + the last set that took this vertex
  for (std::size_t s = 0; s < mesh.sets.size(); ++s) {
    const auto& listed = mesh.sets[s];
    NamedSet set{.name = listed.name, .vertices = {}, .faces = faces_of(mesh, listed)};
    const auto add = [&](Index vertex) {
      auto& last = last_set[static_cast<std::size_t>(vertex)];
      if (last != s + 1) set.vertices.push_back(vertex);
      last = s + 1;
    };
    for (const Index vertex : listed.vertices) add(vertex);
    for (const Index cell : listed.cells) {
      for (const Index vertex : mesh.vertices_of(cell)) add(vertex);
    }
    for (const auto& face : set.faces) {
      for (int i = 0; i < fem::shape(face.type).vertices; ++i) add(face.vertices[static_cast<std::size_t>(i)]);
    }
    std::sort(set.vertices.begin(), set.vertices.end());
    if (!set.vertices.empty()) sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace ritz::readers
