#include "run_body.hpp"

#include <algorithm>

#include "ritz/base/error.hpp"

namespace ritz::tools {
namespace {

template <class Part>
Part required(std::optional<Part> part, const format::ModelReader& in, const std::string& what) {
  if (part) return std::move(*part);
  throw InputError(in.name() + " has no " + what + ": reduce the model again");
}

void fit(Eigen::Index got, Eigen::Index wanted, const format::ModelReader& in, const std::string& part) {
  if (got != wanted)
    throw InputError(in.name() + " is damaged: its " + part + " do not fit its " + std::to_string(wanted) +
                     " coordinates");
}

/// Whether any load or probe acts on a single vertex (or, else, on a named set).
template <class Kind>
bool any_target(const scene::Scene& scene) {
  const auto is = [](const auto& item) { return std::holds_alternative<Kind>(item.target); };
  return std::ranges::any_of(scene.loads, is) || std::ranges::any_of(scene.probes, is);
}

std::string first_body(const format::ModelReader& in) {
  const auto bodies = in.bodies();
  if (bodies.empty()) throw InputError(in.name() + " has no body: reduce the model again");
  return bodies.front();
}

}  // namespace

Eigen::Index reduced_size(const model::Body& body) {
  return body.reduction ? body.reduction->stiffness.size() : body.modes->eigenvalues.size();
}

model::Body read_body(const format::ModelReader& in, const scene::Scene& scene, Frames frames, Forces forces) {
  model::Body body;
  body.name = first_body(in);
  body.reduction = format::read_reduction(in, body.name);
  body.modes = format::read_modes(in, body.name);
  if (!body.reduction) required(body.modes, in, "modes");
  const bool lacks_motions =
      body.reduction && body.modes && std::ranges::count(body.modes->kinds, model::ModeKind::rigid) > 0;
  const Eigen::Index r = reduced_size(body);
  if (forces == Forces::stored) body.polynomial = format::read_polynomial(in, body.name);
  if (body.polynomial) fit(body.polynomial->r, r, in, "polynomial");
  if (frames == Frames::some || any_target<std::int64_t>(scene) || lacks_motions) {
    body.geometry = format::read_geometry(in, body.name);
    body.basis = format::read_basis(in, {}, body.name);
    fit(body.basis.U.cols(), r, in, "columns of U");
  }
  if (any_target<std::string>(scene)) {
    body.loads = format::read_loads(in, body.name);
    for (const auto& load : body.loads) fit(load.total.rows(), r, in, "loads");
  }
  if (scene.gravity || scene.shake || lacks_motions) {
    body.inertia = required(format::read_inertia(in, body.name), in, "inertia, which gravity and shaking need");
    fit(body.inertia->gram.rows(), 4 + 3 * r, in, "inertia");
  }
  return body;
}

model::Body read_mode(const format::ModelReader& in, std::int64_t index) {
  model::Body body;
  body.name = first_body(in);
  if (in.has(format::schema::reduction, body.name))
    throw InputError(in.name() + " has a reduced basis whose columns are not modes: --animate-mode needs a model of " +
                     "modes alone, reduced without -derivatives, -snapshots and -basis");
  body.modes = required(format::read_modes(in, body.name), in, "modes");
  const Eigen::Index r = body.modes->eigenvalues.size();
  fit(format::basis_size(in, body.name).columns, r, in, "columns of U");
  if (index >= r)
    throw InputError("there is no mode " + std::to_string(index + 1) + " in " + in.name() +
                     ": --animate-mode is 1 to " + std::to_string(r));
  body.geometry = format::read_geometry(in, body.name);
  body.basis = format::read_basis(in, {.columns = {{index}}, .vertices = {}}, body.name);
  return body;
}

}  // namespace ritz::tools
