#include "ritz/app/reduced_parts.hpp"

#include <algorithm>
#include <cstdio>

#include "ritz/app/full_start.hpp"
#include "ritz/app/scene_loads.hpp"
#include "ritz/app/snapshots.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/stages/reduce_polynomial.hpp"

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

/// Of whoever asks for a polynomial of other laws the options have been refused before.
stages::PolynomialLaws polynomial_laws(const stages::Problem& problem) {
  return stages::polynomial_laws(problem.materials).value();
}

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

ReducedBasis accurate(const stages::Problem& problem, const stages::ModesResult& modes, const stages::StaticPath& path,
                      double target, const stages::ModesProgress& progress) {
  auto [basis, chosen] = stages::accurate_basis(problem, polynomial_laws(problem), modes, path, target, progress);
  return finished(std::move(basis), Accuracy{target, chosen});
}

}  // namespace

ReducedBasis reduce_basis(const config::Config& config, const stages::Problem& problem,
                          const stages::ModesResult& modes, const std::optional<stages::StaticPath>& path,
                          Progress& progress) {
  if (!config.basis) return {modes.vectors, {}, {}};
  algebra::Tall snapshots(problem.dofs.owned, 0);
  if (config.snapshots) snapshots = read_snapshots(*config.snapshots, problem.mesh, problem.dofs);
  const auto told = [&](const std::string& what, double fraction) { progress.update(what, fraction); };
  auto basis = progress.stage("basis", [&] {
    return path ? accurate(problem, modes, *path, config.accuracy->target, told)
                : finished(stages::basis(problem, modes, snapshots, *config.basis, told), {});
  });
  if (config.basis->derivatives > 0 || config.accuracy)
    basis.figures.taylor_slope = progress.stage("witness", [&] { return taylor(problem, modes, config.basis->modes); });
  return basis;
}

std::optional<ReducedPolynomial> reduce_forces(const config::Config& config, const stages::Problem& problem,
                                               const mesh::VertexRows& u, Progress& progress) {
  if (config.forces == config::ReducedForces::none) return std::nullopt;
  if (u.cols() > stages::most_coordinates)
    throw InputError("a polynomial of " + std::to_string(u.cols()) + " coordinates is too large (at most " +
                     std::to_string(stages::most_coordinates) + "); give -basis R, such as -basis 30");
  auto value =
      progress.stage("polynomial", [&] { return stages::reduce_polynomial(problem, polynomial_laws(problem), u); });
  const auto errors = progress.stage("witness", [&] { return stages::polynomial_witness(problem, u, value); });
  return ReducedPolynomial{std::move(value), errors};
}

std::string basis_lines(const ReducedBasis& basis, const std::optional<ReducedPolynomial>& polynomial,
                        const model::Inertia& inertia) {
  if (!basis.reduction) return "";
  const auto& sigma = basis.reduction->singular_values;
  std::string text = formatted("basis: %td columns; singular values %.3g ... %.3g of %td found, %.3g left out\n",
                               basis.reduction->stiffness.size(), sigma[0],
                               sigma[basis.reduction->stiffness.size() - 1], sigma.size(), basis.reduction->discarded);
  const Eigen::RowVector3d masses = 100 / inertia.mass() * inertia.effective_masses().colwise().sum();
  text += formatted("effective mass of the basis, all columns: %.2f %% %.2f %.2f\n", masses[0], masses[1], masses[2]);
  const auto& [orthonormality, derivatives, taylor_slope, accuracy] = basis.figures;
  if (derivatives)
    text += formatted("modal derivatives: %d pairs, %d solved, %d too small to matter; Taylor slope %.3f\n",
                      derivatives->pairs, derivatives->solved, derivatives->pairs - derivatives->solved,
                      taylor_slope.value_or(0));
  if (accuracy)
    text += formatted(
        "accuracy: %d columns of %d modes and their derivatives; error on the static path %.2e (%.2e asked)\n",
        accuracy->reached.columns, accuracy->reached.modes, accuracy->reached.error, accuracy->target);
  if (polynomial)
    text +=
        formatted("polynomial: %td quartic coefficients; against the full model: force %.1e, energy %.1e, K(0) %.1e\n",
                  polynomial->value.quartic.size(), polynomial->errors.force, polynomial->errors.energy,
                  polynomial->errors.stiffness);
  return text;
}

}  // namespace ritz::app
