#include "ritz/stages/train_cubature.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/runtime/model.hpp"
#include "ritz/stages/cubature_candidates.hpp"
#include "ritz/stages/cubature_columns.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index first_measured = 8;     ///< cells
constexpr double growth = 1.25;         ///< from one measurement to the next
constexpr double no_gradient = 1e-12;   ///< relative to the largest at the start
constexpr Index rows_for_a_cell = 2;    ///< of the least squares problem, at least, where the tolerance decides
constexpr std::uint64_t stream = 4711;  ///< of the first draw of poses

std::vector<PoseDraw> draws(int poses) {
  return {{PoseKind::lift, (poses + 1) / 2, stream},
          {PoseKind::statics, poses / 2, stream + 1},
          {PoseKind::lift, held_out_poses, stream + 2},
          {PoseKind::statics, held_out_poses, stream + 3}};
}

/// Of scaled differences of forces, a column a pose.
model::PoseErrors errors_of(const Eigen::Ref<const MatrixXd>& differences) {
  const VectorXd norms = differences.colwise().norm();
  return {norms.norm() / std::sqrt(static_cast<double>(norms.size())), norms.maxCoeff()};
}

/// The errors of a fit: of its training from the residual, of held-out poses (lifts, then statics) anew. *Collective*.
model::CubatureError measured(const CellBasis& basis, model::Integrand integrand, const CubatureTargets& held,
                              const CubatureColumns& columns, const NonnegativeFit& fit) {
  const auto chosen = columns.chosen(fit);
  std::vector<int> cells;
  for (const auto& [cell, weight] : chosen) cells.push_back(cell);
  MatrixXd sum = MatrixXd::Zero(held.sums.rows(), held.sums.cols());
  each_cell_force(basis, integrand, cells, held.z, [&](Index place, const Eigen::Ref<const MatrixXd>& force) {
    sum += chosen[static_cast<std::size_t>(place)].second * force;
  });
  parallel::sum_in_place(basis.problem.mesh.comm, sum);
  const MatrixXd differences = held.scaled(sum - held.sums);
  return {static_cast<std::int64_t>(fit.numbers.size()),
          errors_of(fit.residual.reshaped(basis.size(), fit.residual.size() / basis.size())),
          errors_of(differences.leftCols(held_out_poses)), errors_of(differences.rightCols(held_out_poses))};
}

double worse_mean(const model::CubatureError& error) {
  return std::max(error.lifts.root_mean_square, error.statics.root_mean_square);
}

/// Fills in the cells of the fit, from the ranks that hold them. *Collective*.
void gather(const CellBasis& basis, const std::vector<std::pair<int, double>>& chosen, model::Cubature& cubature) {
  const mesh::Mesh& mesh = basis.problem.mesh;
  std::vector<std::int64_t> ids, regions, counts;
  std::vector<double> weights, volumes, gradients;
  for (const auto& [cell, weight] : chosen) {
    const auto points = cell_points(basis, cell);
    ids.push_back(mesh.cells.ids[static_cast<std::size_t>(cell)]);
    regions.push_back(mesh.cells.regions[static_cast<std::size_t>(cell)]);
    counts.push_back(points.volumes.size());
    weights.push_back(weight);
    volumes.insert(volumes.end(), points.volumes.begin(), points.volumes.end());
    gradients.insert(gradients.end(), points.gradients.data(), points.gradients.data() + points.gradients.size());
  }
  for (auto* list : {&ids, &regions, &counts}) *list = parallel::gather_all(mesh.comm, *list);
  for (auto* list : {&weights, &volumes, &gradients}) *list = parallel::gather_all(mesh.comm, *list);
  std::vector<std::int64_t> firsts(counts.size());
  std::exclusive_scan(counts.begin(), counts.end(), firsts.begin(), std::int64_t{0});
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return ids[i]; });
  const Index r = basis.size(), points = static_cast<Index>(volumes.size());
  cubature.weights.resize(static_cast<Index>(ids.size()));
  cubature.volumes.resize(points);
  cubature.gradients.resize(9 * points, r);
  cubature.starts = {0};
  const Eigen::Map<const MatrixXd> all_gradients(gradients.data(), r, 9 * points);
  for (const std::size_t i : order) {
    cubature.weights[static_cast<Index>(cubature.cells.size())] = weights[i];
    cubature.cells.push_back(ids[i]);
    cubature.regions.push_back(regions[i]);
    const Index to = cubature.starts.back(), from = firsts[i], count = counts[i];
    for (Index p = 0; p < count; ++p) cubature.volumes[to + p] = volumes[static_cast<std::size_t>(from + p)];
    cubature.gradients.middleRows(9 * to, 9 * count) = all_gradients.middleCols(9 * from, 9 * count).transpose();
    cubature.starts.push_back(to + count);
  }
}

void require_possible(const VectorXd& stiffness, const CubatureOptions& options, std::int64_t candidates) {
  if (stiffness.size() == 0 || !(stiffness.minCoeff() > runtime::rigid_stiffness * stiffness.maxCoeff()))
    throw InputError("a cubature needs a basis without rigid modes, such as one with modal derivatives");
  if (candidates == 0)
    throw InputError(
        "there is nothing for a cubature to integrate: the force of every material is a polynomial, which is "
        "exact without one");
  if (options.cells && *options.cells > candidates)
    throw InputError("a cubature of " + counted(*options.cells, "cell", "cells") + " is asked for, but only " +
                     counted(candidates, "cell", "cells") + " can be chosen");
}

/// Throws where the fit ended before it had what was asked for.
void require_reached(const CubatureOptions& options, const NonnegativeFit& fit, const model::Cubature& cubature) {
  const Index found = fit.weights.size();
  if (options.cells && found < *options.cells)
    throw NumericalError("no cubature of " + counted(*options.cells, "cell", "cells") + " was found: with " +
                         std::to_string(found) + " the fit to the poses is as good as it can be");
  const double error = found > 0 ? worse_mean(cubature.errors.back()) : 1;
  if (!options.cells && !(error <= options.tolerance))
    throw NumericalError("the cubature does not reach the tolerance " + shown(options.tolerance) + ": with " +
                         counted(found, "cell", "cells") + " its error at poses that it was not trained on is " +
                         shown(error, 3) + ", and " +
                         (fit.optimal ? "no further cell improves the fit to those of the training"
                                      : "more cells would fit those of the training rather than the body"));
}

/// Where a training for a tolerance is between an error of 1 and its end.
double done(double error, double tolerance) { return std::clamp(std::log(error) / std::log(tolerance), 0.0, 1.0); }

}  // namespace

model::Cubature train_cubature(const Problem& problem, mesh::VertexRef u, const VectorXd& stiffness,
                               const model::Polynomial& polynomial, const CubatureOptions& options,
                               const ModesProgress& progress) {
  const auto cells = cubature_candidates(problem, options.integrand);
  const auto candidates = parallel::sum(problem.mesh.comm, static_cast<std::int64_t>(cells.size()));
  require_possible(stiffness, options, candidates);
  const CellBasis basis = cell_basis(problem, u);
  progress("poses of the cubature", 0);
  const Poses poses = training_poses({basis, u, stiffness, polynomial, options.amplitude}, draws(options.poses));
  const CubatureTargets all = cubature_targets(poses, stiffness, polynomial, options.integrand);
  const CubatureTargets training = all.of(0, options.poses), held = all.of(options.poses, 2 * held_out_poses);
  progress("cells of the cubature", 0);
  const CubatureColumns columns(basis, options.integrand, training, cells);
  model::Cubature cubature;
  cubature.integrand = options.integrand;
  cubature.largest_energy = poses.exact.energies.head(options.poses).maxCoeff();
  const Index most = options.cells ? Index{*options.cells}
                                   : std::min(static_cast<Index>(candidates), training.sums.size() / rows_for_a_cell);
  const auto measure = [&](const NonnegativeFit& fit) {
    cubature.errors.push_back(measured(basis, options.integrand, held, columns, fit));
  };
  const auto fit = nonnegative_least_squares(
      problem.mesh.comm, columns.distributed(), training.scaled(training.sums).reshaped(),
      {no_gradient, most, first_measured}, [&](const NonnegativeFit& at) -> Index {
        measure(at);
        const Index count = at.weights.size();
        const double error = worse_mean(cubature.errors.back());
        if (!options.cells && error <= options.tolerance) return count;
        progress("cells of the cubature", options.cells ? static_cast<double>(count) / static_cast<double>(most)
                                                        : done(error, options.tolerance));
        return static_cast<Index>(std::ceil(growth * static_cast<double>(count)));
      });
  if (fit.optimal && fit.weights.size() > 0) {
    std::erase_if(cubature.errors, [&](const auto& error) { return error.cells >= fit.weights.size(); });
    measure(fit);
  }
  require_reached(options, fit, cubature);
  gather(basis, columns.chosen(fit), cubature);
  return cubature;
}

}  // namespace ritz::stages
