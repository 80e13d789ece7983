#include "ritz/stages/basis.hpp"

#include <algorithm>
#include <cmath>

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

void add_snapshots(const algebra::Matrix& M, const algebra::ConstTallRef& snapshots, const Cut& cut, Principal& set) {
  if (snapshots.cols() == 0) return;
  double scale = 1;
  if (set.sigma.size() > 0) {
    const MPI_Comm comm = algebra::comm_of(M);
    const Eigen::MatrixXd squares = algebra::inner(comm, snapshots, algebra::multiply(M, snapshots));
    const double largest = std::sqrt(squares.diagonal().maxCoeff());
    scale = largest > 0 ? 1 / largest : 0;
  }
  add(M, set, snapshots * scale, cut);
}

void require_enough(const Principal& set, const Cut& cut) {
  if (set.sigma.size() == 0)
    throw InputError("the modes, derivatives and snapshots span nothing", Reason::nothing_spanned);
  if (cut.size > set.sigma.size())
    throw InputError("the modes, derivatives and snapshots have only " + std::to_string(set.sigma.size()) +
                         " independent directions",
                     Reason::too_few_directions);
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
  const Eigen::MatrixXd gram =
      algebra::inner(mesh.comm, pairs.vectors, algebra::multiply(matrices.mass, pairs.vectors));
  const double error = (gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff();
  if (!(error <= orthonormality_gate))
    throw NumericalError("the basis is not orthonormal: max |UᵀMU - I| is " + shown(error, 3));
  result.orthonormality = error;
  result.U = std::move(pairs.vectors);
  result.reduction.stiffness = pairs.values;
}

}  // namespace

BasisResult basis(const Problem& problem, const ModesResult& modes, mesh::FreeRef snapshots,
                  const BasisOptions& options, const ModesProgress& progress) {
  const EnteringModes in = entering_modes(modes, options.modes);
  if (options.derivatives > in.values.size())
    throw InputError("only " + std::to_string(in.values.size()) + " flexible modes enter the basis",
                     Reason::too_few_modes_for_derivatives);
  const ScaledSource source{problem, modes, in};
  ScaledSet set;
  add_modes(source, static_cast<int>(in.values.size()), options.cut, set);
  add_derivatives(source, whole_cluster(in.values, options.derivatives), options.block, options.cut, progress, set);
  add_snapshots(problem.matrices.mass, snapshots, options.cut, set.principal);
  require_enough(set.principal, options.cut);
  return cut_basis(problem, modes, set, kept(set.principal, options.cut));
}

mesh::FreeRows canonical_directions(const Problem& problem, const Principal& set) {
  algebra::Tall Q = set.Q;
  make_canonical(problem.matrices.mass, set.sigma,
                 fixed_vectors(problem.mesh, problem.dofs, largest_group(set.sigma), direction_stream), Q);
  return Q;
}

BasisResult cut_basis(const Problem& problem, const ModesResult& modes, const ScaledSet& set, int columns) {
  const auto& sigma = set.principal.sigma;
  BasisResult result;
  result.derivatives = set.counts;
  result.reduction.singular_values = sigma;
  result.reduction.discarded = std::sqrt(set.principal.discarded + sigma.tail(sigma.size() - columns).squaredNorm());
  const algebra::Tall Q = canonical_directions(problem, set.principal);
  finish(problem, rigid_modes(modes), Q.leftCols(columns), result);
  return result;
}

}  // namespace ritz::stages
