#include "ritz/readers/listed.hpp"

#include <algorithm>

#include "ritz/base/shown.hpp"

namespace ritz::readers {

IdMap::IdMap(std::span<const Index> ids) {
  if (ids.empty()) return;
  const auto [lowest, highest] = std::minmax_element(ids.begin(), ids.end());
  first_ = *lowest;
  const auto range = static_cast<std::uint64_t>(*highest) - static_cast<std::uint64_t>(*lowest);
  if (range < 8 * ids.size() + 1024) {
    dense_.assign(range + 1, -1);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      auto& slot = dense_[static_cast<std::size_t>(ids[i] - first_)];
      if (slot >= 0 && !duplicate_) duplicate_ = static_cast<Index>(i);
      slot = static_cast<Index>(i);
    }
    return;
  }
  sorted_.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) sorted_.emplace_back(ids[i], static_cast<Index>(i));
  std::sort(sorted_.begin(), sorted_.end());
  const auto twin = std::adjacent_find(sorted_.begin(), sorted_.end(),
                                       [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twin != sorted_.end()) duplicate_ = std::next(twin)->second;
}

Index IdMap::find(Index id) const {
  if (!dense_.empty()) {
    const auto slot = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(first_);
    return slot < dense_.size() ? dense_[slot] : -1;
  }
  const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{id, Index{0}});
  return at != sorted_.end() && at->first == id ? at->second : -1;
}

std::uint64_t IdMap::looked_at(Index first, Index last, Index step) const {
  if (!dense_.empty()) {
    const Index begin = std::max(first, first_), end = std::min(last, first_ + static_cast<Index>(dense_.size()) - 1);
    return begin > end ? 1 : static_cast<std::uint64_t>((end - begin) / step + 1);
  }
  const auto before = [](const auto& entry, Index id) { return entry.first < id; };
  const auto begin = std::lower_bound(sorted_.begin(), sorted_.end(), first, before);
  const auto end = std::lower_bound(begin, sorted_.end(), last, before);
  return static_cast<std::uint64_t>(end - begin) + 1;
}

std::vector<Index> IdMap::range(Index first, Index last, Index step) const {
  std::vector<Index> positions;
  if (!dense_.empty()) {
    const Index end = std::min(last, first_ + static_cast<Index>(dense_.size()) - 1);
    const Index skipped = first_ > first ? (first_ - first) / step : 0;  // steps that end at or before first_
    for (Index id = first + skipped * step; id <= end; id += step) {
      if (const auto position = find(id); position >= 0) positions.push_back(position);
      if (step > end - id) break;
    }
    return positions;
  }
  auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{first, Index{0}});
  for (; at != sorted_.end() && at->first <= last; ++at) {
    if ((at->first - first) % step == 0) positions.push_back(at->second);
  }
  return positions;
}

namespace {

std::string number(Index value) { return std::to_string(value); }

// The file's numbers in cell_vertices become positions. A cell of lower dimension carries a set and no stiffness: it
// may name a vertex twice, as the ends of a closed or collapsed curve do.
void number_vertices(const Sources& sources, const IdMap& vertices, ListedMesh& mesh) {
  for (std::size_t c = 0; c < mesh.shapes.size(); ++c) {
    const auto begin = mesh.cell_vertices.begin() + mesh.cell_offsets[c];
    const auto end = mesh.cell_vertices.begin() + mesh.cell_offsets[c + 1];
    const bool solid = mesh.shapes[c].dimension == 3;
    for (auto v = begin; v != end; ++v) {
      const Index position = vertices.find(*v);
      if (position < 0) {
        fail(sources, mesh.cell_places[c],
             "cell " + number(mesh.cell_ids[c]) + " refers to vertex " + number(*v) + ", which the file does not list");
      }
      if (solid && std::find(begin, v, position) != v) {
        fail(sources, mesh.cell_places[c],
             "cell " + number(mesh.cell_ids[c]) + " names vertex " + number(*v) + " twice");
      }
      *v = position;
    }
  }
}

void check_solids(const Sources& sources, const ListedMesh& mesh) {
  const auto solid = [](Shape shape) { return shape.dimension == 3; };
  if (std::none_of(mesh.shapes.begin(), mesh.shapes.end(), solid)) {
    fail(sources,
         "the mesh has no solid cells; ritz needs tetrahedra (4 or 10 vertices), hexahedra (8 or 20), wedges (6 or 15) "
         "or pyramids (5)");
  }
}

// A name that no region has, for the cells without one.
std::string stray_name(const std::vector<Region>& regions) {
  std::string name = "default";
  const auto taken = [&](const Region& region) { return region.name == name; };
  while (std::any_of(regions.begin(), regions.end(), taken)) name += '_';
  return name;
}

// A region without solid cells is left out.
void take_solids(const ListedMesh& from, FileMesh& to) {
  std::vector<std::int32_t> numbers(from.regions.size() + 1, -1);  // the last: cells without a region
  for (std::size_t c = 0; c < from.shapes.size(); ++c) {
    const auto type = from.shapes[c].cell;
    if (!type) continue;
    const auto vertices = from.vertices_of(static_cast<Index>(c));
    to.cell_types.push_back(*type);
    to.cell_ids.push_back(from.cell_ids[c]);
    to.cell_vertices.insert(to.cell_vertices.end(), vertices.begin(), vertices.end());
    to.cell_offsets.push_back(static_cast<Index>(to.cell_vertices.size()));
    const bool stray = from.cell_regions[c] < 0;
    to.cell_regions.push_back(stray ? static_cast<std::int32_t>(from.regions.size()) : from.cell_regions[c]);
    numbers[static_cast<std::size_t>(to.cell_regions.back())] = 0;
  }
  for (std::size_t r = 0; r < numbers.size(); ++r) {
    if (numbers[r] < 0) continue;
    numbers[r] = static_cast<std::int32_t>(to.regions.size());
    to.regions.push_back(r < from.regions.size() ? from.regions[r] : Region{.name = stray_name(to.regions)});
  }
  for (auto& region : to.cell_regions) region = numbers[static_cast<std::size_t>(region)];
}

}  // namespace

void add_vertex(ListedMesh& mesh, Index id, const std::array<double, 3>& point, Place place) {
  mesh.points.push_back(point);
  mesh.vertex_ids.push_back(id);
  mesh.vertex_places.push_back(place);
}

void add_cell(ListedMesh& mesh, Shape shape, Index id, std::span<const Index> vertices, Place place) {
  mesh.shapes.push_back(shape);
  mesh.cell_ids.push_back(id);
  mesh.cell_places.push_back(place);
  mesh.cell_vertices.insert(mesh.cell_vertices.end(), vertices.begin(), vertices.end());
  mesh.cell_offsets.push_back(static_cast<Index>(mesh.cell_vertices.size()));
  mesh.cell_regions.push_back(-1);
}

void turn_wedge(Shape shape, std::span<Index> vertices) {
  if (!shape.cell || fem::shape(*shape.cell).linear != fem::CellType::wedge6) return;
  std::swap_ranges(vertices.begin(), vertices.begin() + 3, vertices.begin() + 3);
  if (shape.vertices > 6) std::swap_ranges(vertices.begin() + 6, vertices.begin() + 9, vertices.begin() + 9);
}

Numbering numbering(const Sources& sources, const ListedMesh& mesh) {
  if (mesh.points.empty()) fail(sources, "the file lists no vertices; is it a mesh?");
  Numbering result{.vertices = IdMap(mesh.vertex_ids), .cells = IdMap(mesh.cell_ids)};
  if (const auto twice = result.vertices.duplicate()) {
    const auto v = static_cast<std::size_t>(*twice);
    fail(sources, mesh.vertex_places[v], "vertex " + number(mesh.vertex_ids[v]) + " is listed twice");
  }
  if (const auto twice = result.cells.duplicate()) {
    const auto c = static_cast<std::size_t>(*twice);
    fail(sources, mesh.cell_places[c], "cell " + number(mesh.cell_ids[c]) + " is listed twice");
  }
  return result;
}

FileMesh finish(const Sources& sources, ListedMesh mesh) {
  number_vertices(sources, numbering(sources, mesh).vertices, mesh);
  check_solids(sources, mesh);
  tell_kinds_apart(sources, mesh);
  FileMesh result;
  take_solids(mesh, result);
  result.sets = gather_sets(mesh);
  result.points = std::move(mesh.points);
  result.vertex_ids = std::move(mesh.vertex_ids);
  result.supports = std::move(mesh.supports);
  result.notes = std::move(mesh.notes);
  return result;
}

FileMaterial checked(const Sources& sources, Place place, const FileMaterial& material) {
  const auto &young = material.young, &poisson = material.poisson, &density = material.density;
  if (young && !(*young > 0)) fail(sources, place, "Young's modulus must be positive");
  if (poisson && !(*poisson > -1 && *poisson < 0.5)) fail(sources, place, "Poisson's ratio must be in (-1, 1/2)");
  if (density && !(*density > 0)) fail(sources, place, "the density must be positive");
  return material;
}

const fem::AnyLaw& possible(const Sources& sources, Place place, const fem::AnyLaw& law) {
  if (const auto found = fem::impossible(law))
    fail(sources, place,
         "the " + std::string(found->parameter.words) + " of this material cannot be " + shown(found->value));
  return law;
}

void leave_out(const Sources& sources, Place place, const std::string& word, const std::string& what,
               const Ignored& ignored, ListedMesh& mesh) {
  if (std::find(ignored.begin(), ignored.end(), word) == ignored.end())
    fail(sources, place, what + "; '-ignore " + word + "' leaves it out, and the result is then of another model");
  mesh.notes.push_back(located(sources, place) + what + "; it was left out (-ignore " + word + ")");
}

}  // namespace ritz::readers
