#include <algorithm>
#include <charconv>

#include "ritz/mesh/read_inp_model.hpp"

namespace ritz::mesh {
namespace {

/// The model with its numbers and names ready to be looked up.
struct Resolver {
  const Sources& sources;
  InpModel& model;
  Numbering ids;
  std::map<std::string, std::size_t> set_index;  ///< name in capitals -> ListedMesh::sets
};

void add_members(const Resolver& look, const IdMap& ids, const std::string& what, const InpSet& set,
                 std::vector<Index>& positions) {
  for (const auto& member : set.members) {
    const auto found = ids.range(member.first, member.last, std::max<Index>(member.step, 1));
    if (found.empty()) {
      fail(look.sources, member.place,
           "set '" + set.name + "' names " + what + " " + std::to_string(member.first) +
               ", which the file does not list");
    }
    positions.insert(positions.end(), found.begin(), found.end());
  }
}

std::vector<Index> cells_of(const Resolver& look, const InpSet& set) {
  auto cells = set.positions;
  add_members(look, look.ids.cells, "element", set, cells);
  return cells;
}

void add_vertices_of_cells(const Resolver& look, const InpSet& elements, std::vector<Index>& vertices) {
  for (const Index cell : cells_of(look, elements)) {
    for (const Index id : look.model.mesh.vertices_of(cell)) {
      if (const Index vertex = look.ids.vertices.find(id); vertex >= 0) vertices.push_back(vertex);
    }
  }
}

std::vector<Index> vertices_of(const Resolver& look, const InpSet& set) {
  auto vertices = set.positions;
  add_members(look, look.ids.vertices, "node", set, vertices);
  for (const std::size_t elements : set.element_sets) {
    add_vertices_of_cells(look, look.model.element_sets.sets[elements], vertices);
  }
  return vertices;
}

// What a line names: a set, or one number.
template <class PositionsOf>
std::vector<Index> target(const Resolver& look, const std::string& name, Place place, const InpSets& sets,
                          const IdMap& ids, PositionsOf positions_of) {
  if (const auto* const set = sets.find(name)) return positions_of(look, *set);
  Index number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool is_number = error == std::errc() && end == name.data() + name.size();
  const Index position = is_number ? ids.find(number) : -1;
  if (position < 0) fail(look.sources, place, "'" + name + "' is no set and no number in this file");
  return {position};
}

ListedSet& listed_set(Resolver& look, const std::string& name) {
  auto& sets = look.model.mesh.sets;
  const auto [found, added] = look.set_index.try_emplace(upper(name), sets.size());
  if (added) sets.push_back({.name = name, .vertices = {}, .cells = {}, .faces = {}});
  return sets[found->second];
}

void append(std::vector<Index>& to, const std::vector<Index>& from) { to.insert(to.end(), from.begin(), from.end()); }

void add_surface_cell(const Resolver& look, const InpSurfaceEntry& entry, Index cell, ListedSet& set) {
  const auto kind = traits(look.model.mesh.shapes[static_cast<std::size_t>(cell)]);
  const auto& label = entry.label;
  if (kind.dimension == 2 && (label.empty() || label == "SPOS" || label == "SNEG")) {
    set.cells.push_back(cell);
    return;
  }
  const int face = label.size() == 2 && label[0] == 'S' ? label[1] - '1' : -1;
  if (kind.dimension != 3 || face < 0 || face >= fem::shape(*kind.cell).faces) {
    fail(look.sources, entry.place, "face label '" + label + "' does not fit the elements it is used for");
  }
  set.faces.push_back({.cell = cell, .face = face});
}

void resolve_surface(Resolver& look, const InpSurface& surface) {
  auto& model = look.model;
  auto& set = listed_set(look, surface.name);
  for (const auto& entry : surface.entries) {
    if (surface.type == InpSurfaceType::node) {
      append(set.vertices, target(look, entry.target, entry.place, model.node_sets, look.ids.vertices, vertices_of));
      continue;
    }
    for (const Index cell : target(look, entry.target, entry.place, model.element_sets, look.ids.cells, cells_of)) {
      add_surface_cell(look, entry, cell, set);
    }
  }
}

FileMaterial material_of(const Resolver& look, const InpSection& section) {
  const auto found = look.model.materials.find(section.material);
  if (found == look.model.materials.end()) {
    fail(look.sources, section.place, "material " + section.material + " is not defined in the file");
  }
  const auto& material = found->second;
  return {.young = material.young, .poisson = material.poisson, .density = material.density};
}

void claim(const Resolver& look, const InpSection& section, Index cell) {
  auto& mesh = look.model.mesh;
  const auto region = static_cast<std::int32_t>(mesh.regions.size());
  auto& claimed = mesh.cell_regions[static_cast<std::size_t>(cell)];
  if (claimed >= 0 && claimed != region) {
    fail(look.sources, section.place,
         "the section of " + section.element_set + " overlaps that of " +
             mesh.regions[static_cast<std::size_t>(claimed)].name + " in element " +
             std::to_string(mesh.cell_ids[static_cast<std::size_t>(cell)]));
  }
  claimed = region;
}

void resolve_sections(Resolver& look) {
  auto& mesh = look.model.mesh;
  for (const auto& section : look.model.sections) {
    const auto* const set = look.model.element_sets.find(section.element_set);
    if (!set) fail(look.sources, section.place, "element set '" + section.element_set + "' is not defined in the file");
    for (const Index cell : cells_of(look, *set)) claim(look, section, cell);
    mesh.regions.push_back({.name = set->name, .material = material_of(look, section)});
  }
}

// Without sections: the first *ELSET that holds a cell, else the ELSET= of its *ELEMENT.
void regions_from_sets(Resolver& look) {
  auto& mesh = look.model.mesh;
  const auto claim = [&](const InpSet& set, const std::vector<Index>& cells) {
    const auto region = static_cast<std::int32_t>(mesh.regions.size());
    bool any = false;
    for (const Index cell : cells) {
      const auto c = static_cast<std::size_t>(cell);
      if (mesh.cell_regions[c] >= 0 || traits(mesh.shapes[c]).dimension != 3) continue;
      mesh.cell_regions[c] = region;
      any = true;
    }
    if (any) mesh.regions.push_back({.name = set.name, .material = {}});
  };
  for (const auto& set : look.model.element_sets.sets) {
    if (!set.members.empty()) claim(set, cells_of(look, set));
  }
  for (const auto& set : look.model.element_sets.sets) claim(set, set.positions);
}

void resolve_boundary(const Resolver& look, const InpBoundary& boundary) {
  const InpSets &nodes = look.model.node_sets, &elements = look.model.element_sets;
  std::vector<Index> vertices;
  const auto* const cells = nodes.find(boundary.target) ? nullptr : elements.find(boundary.target);
  if (cells) add_vertices_of_cells(look, *cells, vertices);
  else vertices = target(look, boundary.target, boundary.place, nodes, look.ids.vertices, vertices_of);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  look.model.mesh.supports.push_back({.vertices = std::move(vertices), .components = boundary.components});
}

}  // namespace

FileMesh resolve_inp(const Sources& sources, InpModel model) {
  Resolver look{.sources = sources, .model = model, .ids = numbering(sources, model.mesh), .set_index = {}};
  // Element sets first: a union is spelled like the region it may be.
  for (const auto& set : model.element_sets.sets) append(listed_set(look, set.name).cells, cells_of(look, set));
  for (const auto& set : model.node_sets.sets) append(listed_set(look, set.name).vertices, vertices_of(look, set));
  for (const auto& surface : model.surfaces) resolve_surface(look, surface);
  if (model.sections.empty()) regions_from_sets(look);
  else resolve_sections(look);
  for (const auto& boundary : model.boundaries) resolve_boundary(look, boundary);
  return finish(sources, std::move(model.mesh));
}

}  // namespace ritz::mesh
