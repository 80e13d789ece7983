#include "ritz/app/reduced_parts.hpp"

#include <algorithm>
#include <cstdio>

#include "ritz/app/file_geometry.hpp"
#include "ritz/app/full_start.hpp"
#include "ritz/app/scene_loads.hpp"
#include "ritz/app/snapshots.hpp"
#include "ritz/app/static_loads.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/stages/reduce_polynomial.hpp"
#include "ritz/stages/train_cubature.hpp"

namespace ritz::app {
namespace {

constexpr int levels = 4;

/// The loads of a scene when they are largest. Tables are straight between their points: one of these it is.
algebra::Tall largest_load(const scene::Scene& scene, const stages::LoadAt& load, MPI_Comm comm) {
  if (std::holds_alternative<scene::Static>(scene.analysis)) return load(1);
  const double end = std::get<scene::Time>(scene.analysis).end;
  std::vector<double> times = {0, end};
  const auto note = [&](const scene::Table& table) {
    for (const auto& [t, factor] : table.points)
      if (t > 0 && t < end) times.push_back(t);
  };
  for (const auto& one : scene.loads)
    if (one.table) note(*one.table);
  if (scene.shake) note(scene.shake->table);
  algebra::Tall largest = load(0);
  for (const double t : times)
    if (auto now = load(t); algebra::column_norms(comm, now)[0] > algebra::column_norms(comm, largest)[0])
      largest = std::move(now);
  return largest;
}

}  // namespace

std::optional<stages::StaticPath> static_path(const config::Config& config, const std::optional<scene::Scene>& scene,
                                              const stages::Problem& problem, Progress& progress) {
  if (!scene) return std::nullopt;
  const mesh::Dofs& dofs = problem.dofs;
  return progress.stage("full statics", [&] {
    const auto most = largest_load(*scene, scene_loads(*scene, problem), dofs.comm);
    if (algebra::column_norms(dofs.comm, most)[0] == 0)
      throw InputError("option -accuracy_scene " + config.accuracy->scene.string() +
                       ": its loads do not push the body; give it a [[load]] or gravity");
    auto model = stages::full_model(problem, linear_solver(config, dofs));
    stages::StaticPath path{algebra::Tall(dofs.owned, levels), algebra::Tall(dofs.owned, levels)};
    int level = 0;
    stages::full_statics(
        model, {.steps = levels}, {0, algebra::Tall::Zero(dofs.owned, 1), 0},
        [&](double fraction) -> algebra::Tall { return fraction * most; },
        [&](const stages::StaticState& state, const stages::StaticReport&) {
          path.loads.col(level) = state.fraction * most;
          path.truth.col(level++) = state.u;
          progress.update("", state.fraction);
        });
    return std::optional(std::move(path));
  });
}

namespace {

double taylor(const stages::Problem& problem, const stages::ModesResult& modes, const std::vector<int>& chosen) {
  const algebra::Tall entering = stages::entering_modes(modes, chosen).vectors;
  return stages::taylor_witness({problem, modes, entering, static_cast<int>(entering.cols())});
}

ReducedBasis finished(stages::BasisResult basis, std::optional<Accuracy> accuracy) {
  ReducedBasis finished{std::move(basis.U), std::move(basis.reduction), {}};
  finished.figures.orthonormality = basis.orthonormality;
  if (basis.derivatives.pairs > 0) finished.figures.derivatives = basis.derivatives;
  finished.figures.accuracy = accuracy;
  return finished;
}

TrainedForces train(const config::Config& config, const stages::Problem& problem, const stages::BasisResult& basis) {
  const auto u = mesh::to_vertices(problem.mesh, problem.dofs, basis.U);
  auto polynomial = stages::reduce_polynomial(problem, stages::laws_at_rest(problem.materials), u);
  auto cubature = stages::train_cubature(problem, u, basis.reduction.stiffness, polynomial, config.cubature,
                                         [](const std::string&, double) {});
  return {std::move(polynomial), std::move(cubature)};
}

ReducedBasis accurate(const config::Config& config, const stages::Problem& problem, const stages::ModesResult& modes,
                      const stages::StaticPath& path, const stages::ModesProgress& progress) {
  const double target = config.accuracy->target;
  if (const auto laws = stages::polynomial_laws(problem.materials)) {
    auto [basis, chosen] = stages::accurate_basis(problem, *laws, modes, path, target, progress);
    return finished(std::move(basis), Accuracy{target, chosen});
  }
  const auto materials = named_materials(problem.mesh, problem.materials);
  const bool plain = config.cubature.integrand == model::Integrand::energy;
  std::optional<TrainedForces> last;
  const stages::ReducedModel reduced = [&](const stages::BasisResult& basis) {
    last = train(config, problem, basis);
    return runtime::make_model<double>(last->cubature, materials, plain ? nullptr : &last->polynomial, {});
  };
  auto [basis, chosen] = stages::accurate_basis(problem, reduced, modes, path, target, progress);
  auto result = finished(std::move(basis), Accuracy{target, chosen});
  result.trained = std::move(last);
  return result;
}

ReducedBasis make_basis(const config::Config& config, const stages::Problem& problem, const stages::ModesResult& modes,
                        const algebra::Tall& answers, const std::optional<stages::StaticPath>& path,
                        Progress& progress) {
  const auto told = [&](const std::string& what, double fraction) { progress.update(what, fraction); };
  if (path) return accurate(config, problem, modes, *path, told);
  if (!config.basis) {
    const auto residual = stages::residual_vectors(problem, modes.vectors, answers);
    if (residual.values.size() + modes.vectors.cols() == 0)
      throw InputError("the loads move nothing", Reason::nothing_spanned);
    if (residual.values.size() == 0) return {modes.vectors, {}, {}};
    return finished(stages::joined_basis(problem, modes, residual), {});
  }
  algebra::Tall snapshots(problem.dofs.owned, 0);
  if (config.snapshots) snapshots = read_snapshots(*config.snapshots, problem.mesh, problem.dofs);
  const auto given = stages::residual_vectors(problem, stages::rigid_modes(modes), answers).vectors;
  return finished(stages::basis(problem, modes, snapshots, given, *config.basis, told), {});
}

}  // namespace

ReducedBasis reduce_basis(const config::Config& config, const stages::Problem& problem,
                          const stages::ModesResult& modes, const StaticLoads& loads,
                          const std::optional<stages::StaticPath>& path, Progress& progress) {
  const algebra::Tall joining = answers_at(loads.residual, loads.solved, modes.answers);
  ReducedBasis basis{modes.vectors, {}, {}};
  if (config.basis || joining.cols() > 0)
    basis = progress.stage("basis", [&] { return make_basis(config, problem, modes, joining, path, progress); });
  const auto& stiffness = basis.reduction ? basis.reduction->stiffness : modes.modes.eigenvalues;
  basis.figures.static_errors = stages::static_errors(problem, basis.U, stiffness, loads.solved, modes.answers);
  if (config.accuracy || (config.basis && config.basis->derivatives > 0))
    basis.figures.taylor_slope = progress.stage("check", [&] { return taylor(problem, modes, config.basis->modes); });
  return basis;
}

ReducedForces reduce_forces(const config::Config& config, const stages::Problem& problem, const ReducedBasis& basis,
                            const mesh::VertexRows& u, Progress& progress) {
  if (config.forces == config::ReducedForces::none) return {};
  if (u.cols() > stages::most_coordinates)
    throw InputError("a nonlinear model of " + std::to_string(u.cols()) + " coordinates is too large (at most " +
                     std::to_string(stages::most_coordinates) + "); give -basis R, such as -basis 30" +
                     (config.residual_vectors ? ", or fewer -residual_vectors" : ""));
  const auto& trained = basis.trained;
  auto value = trained ? trained->polynomial : progress.stage("polynomial", [&] {
    return stages::reduce_polynomial(problem, stages::laws_at_rest(problem.materials), u);
  });
  const auto errors = progress.stage("check", [&] { return stages::polynomial_witness(problem, u, value); });
  ReducedForces forces{ReducedPolynomial{std::move(value), errors}, {}};
  if (fem::force_degree(problem.materials)) return forces;
  forces.cubature = trained ? trained->cubature : progress.stage("cubature", [&] {
    return stages::train_cubature(problem, u, basis.reduction->stiffness, forces.polynomial->value, config.cubature,
                                  [&](const std::string& what, double fraction) { progress.update(what, fraction); });
  });
  if (config.cubature.integrand == model::Integrand::energy) forces.polynomial.reset();
  return forces;
}

namespace {

std::string polynomial_lines(const ReducedForces& forces, Voice voice) {
  const auto& [value, errors] = *forces.polynomial;
  std::string text = formatted(
      "forces of large displacements (St. Venant-Kirchhoff law%s): a polynomial, which agrees with the full model to "
      "%.0e\n",
      forces.cubature ? " of the same stiffness at rest" : "",
      std::max({errors.force, errors.energy, errors.stiffness}));
  if (voice == Voice::verbose)
    text +=
        formatted("  %td quartic coefficients; differs by %.1e in forces, %.1e in energy, %.1e in stiffness at rest\n",
                  value.quartic.size(), errors.force, errors.energy, errors.stiffness);
  return text;
}

std::string cubature_lines(const ReducedForces& forces) {
  const auto& error = forces.cubature->errors.back();
  return formatted(
      "%s, summed over %td cells: errors of forces at shapes that were not trained on, root mean square %.2g %% of low "
      "modes (largest %.2g %%), %.2g %% of statics (largest %.2g %%)\n",
      forces.polynomial ? "what the materials have beyond it" : "forces of large displacements",
      std::ssize(forces.cubature->cells), 100 * error.lifts.root_mean_square, 100 * error.lifts.largest,
      100 * error.statics.root_mean_square, 100 * error.statics.largest);
}

}  // namespace

std::string basis_lines(const ReducedBasis& basis, const ReducedForces& forces, const model::Inertia& inertia,
                        Voice voice) {
  if (!basis.reduction) return "";
  const bool details = voice == Voice::verbose;
  const auto& [stiffness, residual, sigma, discarded] = *basis.reduction;
  const auto kept = basis.reduction->kept();
  std::string text = formatted("basis: %td columns", stiffness.size());
  if (residual > 0) text += formatted(", %td of them static answers to loads", residual);
  if (kept > 0) text += formatted("; the strongest %td of %td independent shapes", kept, sigma.size());
  if (kept > 0 && details)
    text += formatted(", of singular values %.3g to %.3g, %.3g left out", sigma[0], sigma[kept - 1], discarded);
  if (details && basis.figures.orthonormality)
    text += formatted("; orthonormal to %.1e", *basis.figures.orthonormality);
  text += '\n';
  const Eigen::RowVector3d masses = 100 / inertia.mass() * inertia.effective_masses().colwise().sum();
  text += formatted("effective mass of the basis, all columns: %.2f %% %.2f %.2f\n", masses[0], masses[1], masses[2]);
  const auto& [orthonormality, derivatives, taylor_slope, static_errors, accuracy] = basis.figures;
  if (derivatives) {
    text += formatted("modal derivatives of %d pairs of modes, checked against the full model's forces\n",
                      derivatives->pairs);
    if (details)
      text += formatted(
          "  %d solved in %d iterations, to a residual of %.1e, %d too small to matter; the error of a Taylor series "
          "with them falls with the power %.3f of the amplitude (3 is right)\n",
          derivatives->solved, derivatives->iterations, derivatives->residual, derivatives->pairs - derivatives->solved,
          taylor_slope.value_or(0));
  }
  if (accuracy)
    text += formatted(
        "accuracy: %d columns of the static answer, %d modes and their derivatives; error on the static path "
        "%.2e (%.2e asked)\n",
        accuracy->reached.columns, accuracy->reached.modes, accuracy->reached.error, accuracy->target);
  if (forces.polynomial) text += polynomial_lines(forces, voice);
  if (forces.cubature) text += cubature_lines(forces);
  return text;
}

}  // namespace ritz::app
