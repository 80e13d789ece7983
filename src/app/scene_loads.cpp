#include "ritz/app/scene_loads.hpp"

#include <algorithm>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/set_name.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/full_loads.hpp"

namespace ritz::app {
namespace {

const mesh::Set& meant_set(const mesh::Mesh& mesh, const std::string& name, SetUse use) {
  std::vector<std::string> known;
  for (const auto& set : mesh.sets) known.push_back(set.name);
  const auto& set = *mesh.find(resolve_set(known, name, use, "the mesh, on which the scene acts,"));
  if (set.vertices_total == 0) throw InputError("the scene names the set '" + set.name + "', which is empty");
  return set;
}

}  // namespace

const mesh::Set& find_set(const mesh::Mesh& mesh, const std::string& name) {
  return meant_set(mesh, name, SetUse::vertices);
}

const mesh::Set& find_surface(const mesh::Mesh& mesh, const std::string& name, const std::string& what) {
  const mesh::Set& found = meant_set(mesh, name, SetUse::surface);
  if (found.faces_total > 0) return found;
  std::vector<std::string> surfaces;
  for (const auto& set : mesh.sets)
    if (set.faces_total > 0) surfaces.push_back(set.name);
  throw InputError(what + " needs a surface, and the set '" + found.name + "' has none" +
                   (surfaces.empty() ? "; no set of the mesh has one"
                                     : "; the nearest set with one is '" + nearest(name, surfaces) + "'"));
}

void require_vertex(const mesh::Mesh& mesh, std::int64_t id) {
  const auto end = mesh.ids.begin() + mesh.owned;
  const std::int32_t here = std::find(mesh.ids.begin(), end, id) != end;
  if (parallel::max(mesh.comm, here) > 0) return;
  const auto least = std::min_element(mesh.ids.begin(), end), most = std::max_element(mesh.ids.begin(), end);
  const std::int64_t lowest = parallel::min(mesh.comm, least == end ? std::int64_t{1} << 62 : *least);
  const std::int64_t highest = parallel::max(mesh.comm, most == end ? std::int64_t{-1} : *most);
  throw InputError("the scene names vertex " + std::to_string(id) +
                   ", which the mesh does not have, by the mesh file's own numbers; they run from " +
                   std::to_string(lowest) + " to " + std::to_string(highest));
}

namespace {

Eigen::Vector3d vector(const scene::Vector3& v) { return {v[0], v[1], v[2]}; }

struct Term {
  algebra::Tall force;
  std::optional<scene::Table> table;
};

/// A load at factor 1 over owned vertices.
struct UnitLoad {
  const mesh::Mesh& mesh;
  const scene::Target& target;

  algebra::Tall operator()(const scene::TotalForce& f) const {
    if (const auto* name = std::get_if<std::string>(&target))
      return stages::shared_force(mesh, find_set(mesh, *name), vector(f.newton));
    const auto id = std::get<std::int64_t>(target);
    require_vertex(mesh, id);
    return stages::vertex_force(mesh, id, vector(f.newton));
  }
  algebra::Tall operator()(const scene::EachForce& f) const {
    const auto* name = std::get_if<std::string>(&target);
    const double vertices = name ? static_cast<double>(find_set(mesh, *name).vertices_total) : 1;
    return (*this)(scene::TotalForce{f.newton}) * vertices;
  }
  algebra::Tall operator()(const scene::Pressure& p) const {
    return stages::pressure_force(mesh, find_surface(mesh, std::get<std::string>(target), "pressure"), p.pascal);
  }
  algebra::Tall operator()(const scene::Traction& t) const {
    return stages::traction_force(mesh, find_surface(mesh, std::get<std::string>(target), "traction"),
                                  vector(t.pascal));
  }
};

}  // namespace

stages::LoadAt scene_loads(const scene::Scene& scene, const stages::Problem& problem) {
  const mesh::Mesh& mesh = problem.mesh;
  std::vector<Term> terms;
  // One vector for all loads of the same table: a deck may list a force for each of many vertices.
  const auto add = [&](const algebra::Tall& force, const std::optional<scene::Table>& table) {
    const auto free = mesh::from_vertices(mesh, problem.dofs, force);
    if (const auto term = std::ranges::find(terms, table, &Term::table); term != terms.end()) term->force += free;
    else terms.push_back({free, table});
  };
  for (const auto& load : scene.loads) add(std::visit(UnitLoad{mesh, load.target}, load.kind), load.table);
  if (scene.gravity) add(stages::body_force(mesh, problem.matrices.scalar_mass, vector(*scene.gravity)), std::nullopt);
  if (scene.shake)
    add(stages::body_force(mesh, problem.matrices.scalar_mass, -vector(scene.shake->direction)), scene.shake->table);
  return [terms, &scene, rows = problem.dofs.owned](double t) {
    algebra::Tall force = algebra::Tall::Zero(rows, 1);
    for (const auto& term : terms) force += scene::factor(scene, term.table, t) * term.force;
    return force;
  };
}

SceneProbes::SceneProbes(const scene::Scene& scene, const mesh::Mesh& mesh) : comm_(mesh.comm), asked_(scene.probes) {
  for (const auto& probe : asked_) {
    Probe found{{}, 1};
    if (const auto* name = std::get_if<std::string>(&probe.target)) {
      const mesh::Set& set = find_set(mesh, *name);
      found.total = static_cast<double>(set.vertices_total);
      for (const int v : set.vertices)
        if (v < mesh.owned) found.vertices.push_back(v);
    } else {
      const auto id = std::get<std::int64_t>(probe.target);
      require_vertex(mesh, id);
      const auto end = mesh.ids.begin() + mesh.owned;
      if (const auto here = std::find(mesh.ids.begin(), end, id); here != end)
        found.vertices.push_back(static_cast<int>(here - mesh.ids.begin()));
    }
    probes_.push_back(std::move(found));
  }
}

std::string SceneProbes::header() const {
  std::string text = "t";
  for (const auto& column : scene::probe_columns(asked_)) text += "," + column;
  return text;
}

Eigen::VectorXd SceneProbes::at(const std::array<mesh::VertexRows, 3>& moment) const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(std::ssize(scene::probe_columns(asked_)));
  Eigen::Index at = 0;
  for (std::size_t p = 0; p < probes_.size(); ++p)
    for (const auto quantity : asked_[p].quantities) {
      const auto& rows = moment[static_cast<std::size_t>(quantity)];
      for (const int v : probes_[p].vertices)
        mesh::at_vertex(values, at) += mesh::at_vertex(rows.col(0), v) / probes_[p].total;
      ++at;
    }
  parallel::sum_in_place(comm_, values);
  return values;
}

}  // namespace ritz::app
