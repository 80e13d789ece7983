#include "ritz/world/loads.hpp"

#include <algorithm>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/set_name.hpp"
#include "ritz/runtime/reconstruction.hpp"
#include "ritz/world/body.hpp"

namespace ritz::world {
namespace {

const model::SetLoad& meant_set(const model::Body& body, const std::string& name, SetUse use) {
  std::vector<std::string> known;
  for (const auto& load : body.loads) known.push_back(load.set);
  for (const auto& set : body.geometry.sets)  // also those that are empty, which have no loads
    if (std::ranges::find(known, set.name) == known.end()) known.push_back(set.name);
  const auto meant = resolve_set(known, name, use, "the model");
  const auto load = std::ranges::find(body.loads, meant, &model::SetLoad::set);
  if (load == body.loads.end()) throw InputError("the scene names the set '" + meant + "', which is empty");
  return *load;
}

const model::SetLoad& find_surface(const model::Body& body, const std::string& name, const std::string& what) {
  const auto& found = meant_set(body, name, SetUse::surface);
  if (found.has_surface) return found;
  std::vector<std::string> surfaces;
  for (const auto& load : body.loads)
    if (load.has_surface) surfaces.push_back(load.set);
  throw InputError(what + " needs a surface, and the set '" + found.set + "' has none" +
                   (surfaces.empty() ? "; no set of the model has one"
                                     : "; the nearest set with one is '" + nearest(name, surfaces) + "'"));
}

std::int64_t find_vertex(const model::Body& body, std::int64_t id) {
  const auto& ids = body.geometry.vertex_ids;
  const auto at = std::find(ids.begin(), ids.end(), id);
  if (at != ids.end()) return at - ids.begin();
  const std::string which = "vertex " + std::to_string(id);
  if (body.geometry.rows == model::Rows::surface)
    throw InputError(which +
                     " is not stored in the model, which holds its surface alone: choose a vertex of the "
                     "surface, a named set, or a model of all vertices");
  throw InputError("the model has no " + which + ", by the mesh file's own numbers" +
                   (ids.empty() ? ""
                                : "; they run from " + std::to_string(*std::ranges::min_element(ids)) + " to " +
                                      std::to_string(*std::ranges::max_element(ids))));
}

/// How many vertices share a force.
double vertices_of(const model::Body& body, const scene::Target& target) {
  const auto* name = std::get_if<std::string>(&target);
  return name ? static_cast<double>(meant_set(body, *name, SetUse::vertices).vertices) : 1.0;
}

struct Projection {
  const model::Body& body;
  const scene::Target& target;

  Eigen::VectorXd operator()(const scene::TotalForce& f) const { return unit_force(body, target) * vector(f.newton); }
  Eigen::VectorXd operator()(const scene::EachForce& f) const {
    return unit_force(body, target) * vector(f.newton) * vertices_of(body, target);
  }
  Eigen::VectorXd operator()(const scene::Pressure& p) const {
    return find_surface(body, std::get<std::string>(target), "pressure").pressure * p.pascal;
  }
  Eigen::VectorXd operator()(const scene::Traction& t) const {
    return find_surface(body, std::get<std::string>(target), "traction").traction * vector(t.pascal);
  }
};

}  // namespace

Eigen::MatrixXd unit_force(const model::Body& body, const scene::Target& target) {
  if (const auto* name = std::get_if<std::string>(&target)) return meant_set(body, *name, SetUse::vertices).total;
  const std::int64_t row = find_vertex(body, std::get<std::int64_t>(target));
  return runtime::mean_rows(body.basis, {&row, 1}).transpose();
}

Eigen::Vector3d vector(const scene::Vector3& v) { return {v[0], v[1], v[2]}; }

void ReducedLoad::evaluate(const scene::Scene& scene, double t, Eigen::Ref<Eigen::VectorXd> force) const {
  force.setZero();
  for (const auto& term : terms) force += scene::factor(scene, term.table, t) * term.force;
}

ReducedLoad reduce_loads(const scene::Scene& scene, const model::Body& body) {
  ReducedLoad reduced;
  // One term for all loads of the same table: a deck may list a force for each of many vertices.
  const auto add = [&](const Eigen::VectorXd& force, const std::optional<scene::Table>& table) {
    const auto term = std::ranges::find(reduced.terms, table, &ReducedLoad::Term::table);
    if (term != reduced.terms.end()) term->force += force;
    else reduced.terms.push_back({force, table});
  };
  for (const auto& load : scene.loads) add(std::visit(Projection{body, load.target}, load.kind), load.table);
  if (scene.gravity || scene.shake) {
    const Eigen::MatrixXd translations = body.inertia->rigid_coupling().leftCols<3>();
    if (scene.gravity) add(translations * vector(*scene.gravity), std::nullopt);
    if (scene.shake) add(-translations * vector(scene.shake->direction), scene.shake->table);
  }
  return reduced;
}

Eigen::MatrixXd probe_matrix(const scene::Scene& scene, const model::Body& body) {
  Eigen::MatrixXd P(3 * scene.probes.size(), reduced_size(body));
  Eigen::Index row = 0;
  for (const auto& probe : scene.probes) {
    P.middleRows<3>(row) = unit_force(body, probe.target).transpose();
    row += 3;
  }
  return P;
}

}  // namespace ritz::world
