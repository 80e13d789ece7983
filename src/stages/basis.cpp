#include "ritz/stages/basis.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ritz/algebra/handle.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/stages/canonical.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr std::uint64_t basis_sign_stream = 3000, direction_stream = 3001;

}  // namespace

EnteringModes entering_modes(const ModesResult& modes, const std::vector<int>& chosen) {
  const auto vectors = flexible_modes(modes);
  const Index flexible = vectors.cols();
  const auto values = modes.modes.eigenvalues.tail(flexible);
  if (chosen.empty()) return {values, vectors};
  std::vector<Index> columns;
  for (const int mode : chosen) {
    if (mode > flexible)
      throw InputError(
          "there is no flexible mode " + std::to_string(mode) + " among the " + std::to_string(flexible) + " computed",
          Reason::mode_absent);
    columns.push_back(mode - 1);
  }
  return {values(columns), vectors(Eigen::all, columns)};
}

namespace {

void add_snapshots(const algebra::Matrix& M, const algebra::ConstTallRef& given, const algebra::ConstTallRef& snapshots,
                   const Cut& cut, Principal& set) {
  if (snapshots.cols() == 0) return;
  double scale = 1;
  if (set.sigma.size() > 0) {
    const MPI_Comm comm = algebra::comm_of(M);
    const Eigen::MatrixXd squares = algebra::inner(comm, snapshots, algebra::multiply(M, snapshots));
    const double largest = std::sqrt(squares.diagonal().maxCoeff());
    scale = largest > 0 ? 1 / largest : 0;
  }
  add_besides(M, given, snapshots * scale, cut, set);
}

void require_enough(const Principal& set, Index given, const Cut& cut) {
  if (set.sigma.size() + given == 0)
    throw InputError("the modes, derivatives and snapshots span nothing", Reason::nothing_spanned);
  if (cut.size > set.sigma.size())
    throw InputError("the modes, derivatives and snapshots have only " + std::to_string(set.sigma.size()) +
                         " independent directions" + (given > 0 ? " beside the residual vectors" : ""),
                     Reason::too_few_directions);
}

/// max |UᵀMU − I|.
double checked_orthonormality(const algebra::Matrix& M, const algebra::Tall& U) {
  const Eigen::MatrixXd gram = algebra::inner(algebra::comm_of(M), U, algebra::multiply(M, U));
  const double error = (gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff();
  if (!(error <= orthonormality_gate))
    throw NumericalError("the basis is not orthonormal: max |UᵀMU - I| is " + shown(error, 3));
  return error;
}

/// Turns the directions so that UᵀKU is diagonal, and fixes their signs.
void finish(const Problem& problem, const algebra::Tall& R, const algebra::ConstTallRef& directions,
            BasisResult& result) {
  const auto& [mesh, dofs, materials, matrices] = problem;
  RitzPairs pairs = rayleigh_ritz(matrices.stiffness, matrices.mass, R, directions);
  if (pairs.vectors.cols() < directions.cols())
    throw NumericalError(
        "the basis lost " + std::to_string(directions.cols() - pairs.vectors.cols()) + " of its directions to rounding",
        Reason::directions_lost);
  const auto W = fixed_vectors(mesh, dofs, largest_group(pairs.values), basis_sign_stream);
  make_canonical(matrices.mass, pairs.values, W, pairs.vectors);
  result.orthonormality = checked_orthonormality(matrices.mass, pairs.vectors);
  result.U = std::move(pairs.vectors);
  result.reduction.stiffness = pairs.values;
}

}  // namespace

BasisResult basis(const Problem& problem, const ModesResult& modes, mesh::FreeRef snapshots, const algebra::Tall& given,
                  const BasisOptions& options, const ModesProgress& progress) {
  const EnteringModes in = entering_modes(modes, options.modes);
  if (options.derivatives > in.values.size())
    throw InputError("only " + std::to_string(in.values.size()) + " flexible modes enter the basis",
                     Reason::too_few_modes_for_derivatives);
  const ScaledSource source{problem, modes, in, given};
  ScaledSet set;
  add_modes(source, static_cast<int>(in.values.size()), options.cut, set);
  add_derivatives(source, whole_cluster(in.values, options.derivatives), options.block, options.cut, progress, set);
  add_snapshots(problem.matrices.mass, given, snapshots, options.cut, set.principal);
  require_enough(set.principal, given.cols(), options.cut);
  return cut_basis(problem, modes, given, set, kept(set.principal, options.cut));
}

BasisResult joined_basis(const Problem& problem, const ModesResult& modes, const RitzPairs& residual) {
  const Index known = modes.vectors.cols(), all = known + residual.values.size();
  algebra::Tall columns(modes.vectors.rows(), all);
  columns << modes.vectors, residual.vectors;
  Eigen::VectorXd stiffness(all);
  stiffness << modes.modes.eigenvalues, residual.values;
  // Those of residual vectors are above the last mode's, unless a mode is missing among uncertified ones.
  std::vector<Index> order(static_cast<std::size_t>(all));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index i, Index j) { return stiffness[i] < stiffness[j]; });
  BasisResult result;
  result.U = algebra::Tall(columns(Eigen::all, order));
  result.reduction.stiffness = stiffness(order);
  result.reduction.residual_vectors = residual.values.size();
  result.orthonormality = checked_orthonormality(problem.matrices.mass, result.U);
  return result;
}

mesh::FreeRows canonical_directions(const Problem& problem, const Principal& set) {
  if (set.sigma.size() == 0) return algebra::Tall(problem.dofs.owned, 0);
  algebra::Tall Q = set.Q;
  make_canonical(problem.matrices.mass, set.sigma,
                 fixed_vectors(problem.mesh, problem.dofs, largest_group(set.sigma), direction_stream), Q);
  return Q;
}

BasisResult cut_basis(const Problem& problem, const ModesResult& modes, mesh::FreeRef given, const ScaledSet& set,
                      int columns) {
  const auto& sigma = set.principal.sigma;
  BasisResult result;
  result.derivatives = set.counts;
  result.reduction.residual_vectors = given.cols();
  result.reduction.singular_values = sigma;
  result.reduction.discarded = std::sqrt(set.principal.discarded + sigma.tail(sigma.size() - columns).squaredNorm());
  algebra::Tall directions(given.rows(), given.cols() + columns);
  directions << given, canonical_directions(problem, set.principal).leftCols(columns);
  finish(problem, rigid_modes(modes), directions, result);
  return result;
}

}  // namespace ritz::stages
