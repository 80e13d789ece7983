#include "ritz/readers/inp_model.hpp"

#include <algorithm>

#include "ritz/base/set_name.hpp"

namespace ritz::readers {

namespace {

/// The model with its numbers and names ready to be looked up.
struct Resolver {
  const Sources& sources;
  InpBudget budget = InpBudget(sources);
  InpMissing missing_nodes = {};
  InpMissing missing_elements = {};
  InpModel& model;
  Numbering ids;
};

std::size_t position_of(const InpSets& sets, const InpSet& set) {
  return static_cast<std::size_t>(&set - sets.sets.data());
}

InpContent elements_of(Resolver& look, const InpSet& set) {
  const auto& sets = look.model.element_sets;
  return content(look.sources, sets, position_of(sets, set), look.ids.cells, "element", look.budget,
                 look.missing_elements);
}

std::vector<Index> cells_of(Resolver& look, const InpSet& set) { return elements_of(look, set).positions; }

void add_vertices_of_cells(Resolver& look, const InpSet& elements, std::vector<Index>& vertices) {
  for (const Index cell : cells_of(look, elements)) {
    const auto ids = look.model.mesh.vertices_of(cell);
    look.budget.spend(look.sources, elements.name, ids.size());
    for (const Index id : ids) {
      if (const Index vertex = look.ids.vertices.find(id); vertex >= 0) vertices.push_back(vertex);
    }
  }
}

std::vector<Index> vertices_of(Resolver& look, const InpSet& set) {
  const auto& sets = look.model.node_sets;
  auto [vertices, element_sets, by_number] =
      content(look.sources, sets, position_of(sets, set), look.ids.vertices, "node", look.budget, look.missing_nodes);
  for (const std::size_t elements : element_sets)
    add_vertices_of_cells(look, look.model.element_sets.sets[elements], vertices);
  keep_unique(vertices);
  return vertices;
}

// What a line names: a set, or one number.
template <class PositionsOf>
std::vector<Index> target(Resolver& look, const std::string& name, Place place, const InpSets& sets, const IdMap& ids,
                          PositionsOf positions_of) {
  if (const auto* const set = sets.find(name)) return positions_of(look, *set);
  const auto number = whole_number(name);
  const Index position = number ? ids.find(*number) : -1;
  if (position < 0) fail(look.sources, place, "'" + name + "' is no set and no number in this file");
  return {position};
}

void append(std::vector<Index>& to, const std::vector<Index>& from) { to.insert(to.end(), from.begin(), from.end()); }

void add_surface_cell(const Resolver& look, const InpSurfaceEntry& entry, Index cell, ListedSet& set) {
  const auto kind = look.model.mesh.shapes[static_cast<std::size_t>(cell)];
  const auto& label = entry.label;
  if (kind.dimension == 2 && (label.empty() || label == "SPOS" || label == "SNEG")) {
    set.cells.push_back(cell);
    return;
  }
  const int face = label.size() == 2 && label[0] == 'S' ? label[1] - '1' : -1;
  if (kind.dimension != 3 || face < 0 || face >= std::ssize(fem::shape(*kind.cell).faces)) {
    fail(look.sources, entry.place, "face label '" + label + "' does not fit the elements it is used for");
  }
  set.faces.push_back({.cell = cell, .face = face});
}

void resolve_surface(Resolver& look, const InpSurface& surface) {
  auto& model = look.model;
  auto& set = listed_set(model, surface.name, "surface");
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

std::string said(const Sources& sources, const InpUnread& unread) {
  return unread.what.empty() ? std::string() : located(sources, unread.place) + unread.what;
}

/// `material` with a law of *HYPERELASTIC or of orthotropic *ELASTIC, whose axes the section's orientation turns.
FileMaterial with_law(const Resolver& look, const InpSection& section, const fem::AnyLaw& law, FileMaterial material) {
  material.law = law;
  material.young = material.poisson = std::nullopt;
  if (const auto* isochoric = std::get_if<fem::IsochoricNeoHookean>(&law)) {
    material.young = isochoric->young;
    material.poisson = isochoric->poisson;
  }
  const auto* orthotropic = std::get_if<fem::OrthotropicStVK>(&law);
  if (!orthotropic || section.orientation.empty()) return material;
  const auto found = look.model.orientations.find(section.orientation);
  if (found == look.model.orientations.end())
    fail(look.sources, section.place, "orientation '" + section.orientation + "' is not defined in the file");
  if (!found->second.unread.what.empty()) {
    material.law.reset();
    material.unread_law = said(look.sources, found->second.unread);
    return material;
  }
  auto values = orthotropic->values();
  std::copy(found->second.axes.begin(), found->second.axes.end(), values.end() - 6);
  material.law = fem::OrthotropicStVK(values);
  if (const auto wrong = fem::unstable_at_rest(*material.law))
    fail(look.sources, section.place, "orientation '" + section.orientation + "': its two axes are parallel");
  return material;
}

FileMaterial material_of(const Resolver& look, const InpSection& section) {
  const auto found = look.model.materials.find(section.material);
  if (found == look.model.materials.end()) {
    fail(look.sources, section.place, "material '" + section.material + "' is not defined in the file");
  }
  const auto& material = found->second;
  const bool readable = material.law.what.empty();  // another law beside these, or after them, is the one that counts
  FileMaterial result{.young = material.young,
                      .poisson = material.poisson,
                      .density = material.density,
                      .unread_law = said(look.sources, material.law),
                      .unread_density = said(look.sources, material.unread_density)};
  if (!readable) result.young = result.poisson = std::nullopt;
  if (readable && material.known_law) result = with_law(look, section, *material.known_law, result);
  return result;
}

void claim(Resolver& look, const InpSection& section, Index cell) {
  auto& mesh = look.model.mesh;
  if (mesh.shapes[static_cast<std::size_t>(cell)].dimension < 3) {
    const auto& type = element_type(look.model, cell);
    leave_out(look.sources, section.place, {type},
              "*SOLID SECTION gives elements of type " + type +
                  " stiffness and mass, which ritz cannot do: here they "
                  "carry sets",
              look.model);
    return;
  }
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
      if (mesh.cell_regions[c] >= 0 || mesh.shapes[c].dimension != 3) continue;
      mesh.cell_regions[c] = region;
      any = true;
    }
    if (any) mesh.regions.push_back({.name = set.name, .material = {}});
  };
  for (const auto& set : look.model.element_sets.sets)
    if (const auto listed = elements_of(look, set); listed.by_number) claim(set, listed.positions);
  for (const auto& set : look.model.element_sets.sets) claim(set, cells_of(look, set));
}

void resolve_boundary(Resolver& look, const InpBoundary& boundary) {
  const InpSets &nodes = look.model.node_sets, &elements = look.model.element_sets;
  std::vector<Index> vertices;
  const auto* const cells = nodes.find(boundary.target) ? nullptr : elements.find(boundary.target);
  if (cells) add_vertices_of_cells(look, *cells, vertices);
  else vertices = target(look, boundary.target, boundary.place, nodes, look.ids.vertices, vertices_of);
  keep_unique(vertices);
  if (vertices.empty() && look.model.words.insert("EMPTY SUPPORT").second)
    look.model.mesh.notes.push_back(located(look.sources, boundary.place) + "*BOUNDARY holds '" + boundary.target +
                                    "', which has no nodes: nothing is held by this line");
  look.model.mesh.supports.push_back({.vertices = std::move(vertices), .held = boundary.components});
}

void refuse_structures(Resolver& look) {
  for (const auto& [word, what, name, place] : look.model.structures) {
    const auto* const set = look.model.element_sets.find(name);
    if (!set || !cells_of(look, *set).empty()) leave_out(look.sources, place, {word}, what, look.model);
  }
}

// A vertex that is held in all directions is held in any system.
void refuse_transforms(Resolver& look) {
  if (look.model.transforms.empty()) return;
  auto& mesh = look.model.mesh;
  std::vector<std::array<bool, 3>> held(mesh.points.size());
  for (const auto& support : mesh.supports)
    for (const Index v : support.vertices)
      for (std::size_t i = 0; i < 3; ++i)
        held[static_cast<std::size_t>(v)][i] = held[static_cast<std::size_t>(v)][i] || support.held[i];
  const auto partly = [&](Index v) {
    const auto& h = held[static_cast<std::size_t>(v)];
    return (h[0] || h[1] || h[2]) && !(h[0] && h[1] && h[2]);
  };
  for (const auto& [word, what, name, place] : look.model.transforms) {
    const auto vertices = target(look, name, place, look.model.node_sets, look.ids.vertices, vertices_of);
    if (std::any_of(vertices.begin(), vertices.end(), partly)) leave_out(look.sources, place, {word}, what, look.model);
  }
}

void note_missing(InpModel& model, const InpMissing& missing) {
  if (missing.all.empty()) return;
  const auto others = missing.all.size() - 1;
  model.mesh.notes.push_back(missing.first +
                             (others > 0 ? " (nor " + std::to_string(others) + " others in sets)" : "") +
                             "; the sets do without");
}

}  // namespace

ListedSet& listed_set(InpModel& model, const std::string& name, std::string_view kind) {
  auto& sets = model.mesh.sets;
  const auto spelled = model.spelling.try_emplace(upper(name), name).first->second;
  const auto [found, added] = model.set_index.try_emplace(of_kind(kind, upper(name)), sets.size());
  if (added) sets.push_back({.name = spelled, .vertices = {}, .cells = {}, .faces = {}, .kind = kind});
  return sets[found->second];
}

void note_idle_words(InpModel& model) {
  for (const auto& word : model.ignored)
    if (!model.words.contains(word))
      model.mesh.notes.push_back("option -ignore " + word +
                                 " left nothing out: the mesh file has nothing of that name that ritz would refuse");
}

void resolve_inp(const Sources& sources, InpModel& model) {
  Resolver look{.sources = sources, .model = model, .ids = numbering(sources, model.mesh)};
  // Element sets first: a name is spelled like the region that it may be.
  for (const auto& set : model.element_sets.sets)
    append(listed_set(model, set.name, "elset").cells, cells_of(look, set));
  for (const auto& set : model.node_sets.sets)
    append(listed_set(model, set.name, "nset").vertices, vertices_of(look, set));
  for (const auto& surface : model.surfaces) resolve_surface(look, surface);
  press_faces(sources, look.budget, model);
  if (model.sections.empty()) regions_from_sets(look);
  else resolve_sections(look);
  for (const auto& boundary : model.boundaries) resolve_boundary(look, boundary);
  refuse_structures(look);
  refuse_transforms(look);
  note_missing(model, look.missing_nodes);
  note_missing(model, look.missing_elements);
}

}  // namespace ritz::readers
