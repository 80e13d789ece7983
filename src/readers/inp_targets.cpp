// What loads act on: vertices, faces, cells.
#include <algorithm>

#include "ritz/base/set_name.hpp"
#include "ritz/readers/inp_scene.hpp"

namespace ritz::readers {

namespace {

using Corners = std::array<Index, 4>;

/// The mesh as loads see it.
struct Acted {
  const Sources& sources;
  InpModel& model;
  Numbering ids = numbering(sources, model.mesh);
  std::vector<bool> used = {};          ///< whether a solid element has the vertex
  std::map<Corners, Index> faces = {};  ///< those that loads act on, and their numbers
  std::vector<int> sides = {};          ///< the solid elements of each of them
};

bool acts_on_faces(const InpActing& acting) {
  return acting.action == InpAction::pressure || acting.action == InpAction::traction;
}

Corners listed_corners(const ListedMesh& mesh, const ListedFace& face) {
  const auto cell = mesh.vertices_of(face.cell);
  const auto local = fem::side(*mesh.shapes[static_cast<std::size_t>(face.cell)].cell, face.face).corners();
  Corners corners = {-1, -1, -1, -1};
  std::transform(local.begin(), local.end(), corners.begin(), [&](int i) { return cell[static_cast<std::size_t>(i)]; });
  std::sort(corners.begin(), corners.end());
  return corners;
}

void look_at_cells(Acted& acted) {
  const auto& mesh = acted.model.mesh;
  acted.used.assign(mesh.points.size(), false);
  acted.sides.assign(acted.faces.size(), 0);
  for (Index c = 0; c < std::ssize(mesh.shapes); ++c) {
    const auto& type = mesh.shapes[static_cast<std::size_t>(c)].cell;
    if (!type) continue;
    for (const Index id : mesh.vertices_of(c))
      if (const Index v = acted.ids.vertices.find(id); v >= 0) acted.used[static_cast<std::size_t>(v)] = true;
    for (int f = 0; !acted.faces.empty() && f < std::ssize(fem::shape(*type).faces); ++f)
      if (const auto found = acted.faces.find(listed_corners(mesh, {c, f})); found != acted.faces.end())
        ++acted.sides[static_cast<std::size_t>(found->second)];
  }
}

const ListedSet* listed(const InpModel& model, const std::string& key) {
  const auto found = model.set_index.find(key);
  return found == model.set_index.end() ? nullptr : &model.mesh.sets[found->second];
}

[[noreturn]] void refuse_target(const Acted& acted, const InpActing& acting, const std::string& why) {
  const auto& load = *acting.load;
  fail(acted.sources, load.fields[0].place,
       "*" + keyword_of(acted.model, load).title + " acts on '" + load.target + "', " + why);
}

void find_vertices(Acted& acted, InpActing& acting) {
  const auto& target = acting.load->target;
  std::vector<Index> vertices;
  if (const auto* const set = listed(acted.model, of_kind("nset", upper(target)))) {
    acting.set = of_kind("nset", upper(target));
    vertices = set->vertices;
  } else {
    acting.vertex = whole_number(target);
    vertices = {acting.vertex ? acted.ids.vertices.find(*acting.vertex) : -1};
    if (vertices[0] < 0) refuse_target(acted, acting, "which is no node set and no node of this file");
  }
  const Index component = *whole_number(label_of(*acting.load)) - 1;
  for (const Index v : vertices)
    if (acted.used[static_cast<std::size_t>(v)]) acting.on.push_back(3 * v + component);
  if (acting.on.empty())
    leave_out(acted.sources, acting.load->fields[0].place, {"CLOAD"},
              "*CLOAD acts on '" + target + "', of which no solid element has a node", acted.model);
}

// The surface of a *DSLOAD, which must be of faces of solid elements alone.
std::string named_surface(const Acted& acted, const InpActing& acting) {
  const auto name = upper(acting.load->target);
  const auto& surfaces = acted.model.surfaces;
  const auto found = std::find_if(surfaces.begin(), surfaces.end(), [&](auto& s) { return upper(s.name) == name; });
  if (found == surfaces.end()) refuse_target(acted, acting, "which is no surface that ritz reads");
  for (const auto& [target, label, place] : found->entries)
    if (label.size() != 2 || label[0] != 'S' || label[1] < '1' || label[1] > '6')
      refuse_target(acted, acting, "which has other parts than faces S1 ... S6 of solid elements");
  return of_kind("surface", name);
}

void find_faces(Acted& acted, InpActing& acting) {
  const auto& load = *acting.load;
  if (keyword_of(acted.model, load).name == "DSLOAD") acting.set = named_surface(acted, acting);
  else if (load.faces.empty()) refuse_target(acted, acting, load.unfit);
  else acting.set = of_kind("surface", upper(load.faces));
  for (const auto& face : listed(acted.model, acting.set)->faces) {
    const auto corners = listed_corners(acted.model.mesh, face);
    acting.on.push_back(acted.faces.try_emplace(corners, std::ssize(acted.faces)).first->second);
  }
  std::sort(acting.on.begin(), acting.on.end());
  if (std::adjacent_find(acting.on.begin(), acting.on.end()) != acting.on.end())
    refuse_target(acted, acting, "which lists a face twice");
}

void find_cells(Acted& acted, InpActing& acting) {
  const auto& target = acting.load->target;
  const auto& shapes = acted.model.mesh.shapes;
  const auto add = [&](Index cell) {
    if (shapes[static_cast<std::size_t>(cell)].cell) acting.on.push_back(cell);
  };
  if (const auto* const set = listed(acted.model, of_kind("elset", upper(target)))) {
    std::for_each(set->cells.begin(), set->cells.end(), add);
  } else if (target.empty()) {
    for (Index c = 0; c < std::ssize(shapes); ++c) add(c);
  } else {
    const auto number = whole_number(target);
    const Index cell = number ? acted.ids.cells.find(*number) : -1;
    if (cell < 0) refuse_target(acted, acting, "which is no element set and no element of this file");
    add(cell);
  }
}

void refuse_inner_faces(const Acted& acted, const InpActing& acting) {
  const auto inside = [&](Index face) { return acted.sides[static_cast<std::size_t>(face)] > 1; };
  if (std::any_of(acting.on.begin(), acting.on.end(), inside))
    refuse_target(acted, acting,
                  "of which a face lies between two elements: ritz has pressure on the boundary of a body alone");
}

void refuse_turned(const Acted& acted, const std::vector<std::vector<InpActing>>& steps) {
  std::set<Index> turned;
  for (const auto& [word, what, name, place] : acted.model.transforms) {
    const auto number = whole_number(name);
    if (const auto* const set = listed(acted.model, of_kind("nset", upper(name))))
      turned.insert(set->vertices.begin(), set->vertices.end());
    else if (number) turned.insert(acted.ids.vertices.find(*number));
  }
  for (const auto& step : steps)
    for (const auto& acting : step)
      if (acting.action == InpAction::force)
        for (const Index i : acting.on)
          if (turned.contains(i / 3))
            refuse_target(acted, acting,
                          "where *TRANSFORM turns the directions, which ritz cannot do; write the force along x, y, z");
}

}  // namespace

void find_targets(const Sources& sources, InpModel& model, std::vector<std::vector<InpActing>>& steps) {
  Acted acted{.sources = sources, .model = model};
  for (auto& step : steps)
    for (auto& acting : step)
      if (acts_on_faces(acting)) find_faces(acted, acting);
  look_at_cells(acted);
  for (auto& step : steps) {
    for (auto& acting : step) {
      if (acts_on_faces(acting)) refuse_inner_faces(acted, acting);
      else if (acting.action == InpAction::force) find_vertices(acted, acting);
      else find_cells(acted, acting);
    }
    std::erase_if(step, [](const InpActing& acting) { return acting.on.empty(); });
  }
  if (!model.transforms.empty()) refuse_turned(acted, steps);
}

}  // namespace ritz::readers
