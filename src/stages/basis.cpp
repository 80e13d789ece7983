#include "ritz/stages/basis.hpp"

#include <algorithm>
#include <cmath>

#include "ritz/base/error.hpp"
#include "ritz/stages/canonical.hpp"
#include "ritz/stages/fixed_vectors.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;

constexpr std::uint64_t sign_stream = 3000;
constexpr double orthonormality_gate = 1e-11;

/// K' raised to the end of a cluster.
int whole_cluster(const Eigen::VectorXd& values, int count) {
  while (count > 0 && count < values.size() && values[count] - values[count - 1] <= cluster_gap * values[count])
    ++count;
  return count;
}

void add_modes(Mat M, const Eigen::VectorXd& values, const petsc::Tall& flexible, const Cut& cut, Principal& set) {
  if (values.size() > 0) add(M, set, flexible * (values[0] / values.array()).matrix().asDiagonal(), cut);
}

/// The flexible modes that enter the basis.
struct Entering {
  Eigen::VectorXd values;
  petsc::Tall vectors;
};

Entering entering(const ModesResult& modes, const std::vector<int>& chosen) {
  const auto vectors = flexible_modes(modes);
  const Index flexible = vectors.cols();
  const auto values = modes.modes.eigenvalues.tail(flexible);
  if (chosen.empty()) return {values, vectors};
  std::vector<Index> columns;
  for (const int mode : chosen) {
    if (mode > flexible)
      throw InputError("option -basis_modes: there is no flexible mode " + std::to_string(mode) + " among the " +
                       std::to_string(flexible) + " computed; raise -modes");
    columns.push_back(mode - 1);
  }
  return {values(columns), vectors(Eigen::all, columns)};
}

void add_derivatives(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Full& full, const ModesResult& modes,
                     const Entering& in, const BasisOptions& options, const ModesProgress& progress, Principal& set,
                     BasisResult& result) {
  const Eigen::VectorXd& values = in.values;
  const int count = whole_cluster(values, options.derivatives);
  const petsc::Tall flexible = in.vectors.leftCols(count);
  const auto weight = [&](Pair p) { return values[0] / values[p.i] * (values[0] / values[p.j]); };
  const int all = count * (count + 1) / 2;
  int done = 0;
  const auto take = [&](const DerivativeBlock& block) {
    Eigen::VectorXd scale(static_cast<Index>(block.pairs.size()));
    for (std::size_t p = 0; p < block.pairs.size(); ++p) scale[static_cast<Index>(p)] = weight(block.pairs[p]);
    add(full.mass, set, block.columns * scale.asDiagonal(), options.cut);
    progress("derivatives", double(done += static_cast<int>(block.pairs.size())) / all);
  };
  const auto counts = derivatives(
      {mesh, dofs, full, modes, flexible}, options.block, weight, [&] { return dispensable(set, options.cut); }, take);
  set.discarded += counts.skipped;
  result.figures.insert(result.figures.end(), {{"derivative_pairs", counts.pairs},
                                               {"derivatives_solved", counts.solved},
                                               {"derivatives_skipped", counts.pairs - counts.solved},
                                               {"derivative_iterations", counts.iterations},
                                               {"derivative_residual", counts.residual}});
}

void add_snapshots(const Full& full, const petsc::ConstTallRef& snapshots, const Cut& cut, Principal& set) {
  if (snapshots.cols() == 0) return;
  double scale = 1;
  if (set.sigma.size() > 0) {
    const MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(full.mass.get()));
    const Eigen::MatrixXd squares = petsc::inner(comm, snapshots, petsc::multiply(full.mass, snapshots));
    const double largest = std::sqrt(squares.diagonal().maxCoeff());
    scale = largest > 0 ? 1 / largest : 0;
  }
  add(full.mass, set, snapshots * scale, cut);
}

void require_enough(const Principal& set, const Cut& cut) {
  if (set.sigma.size() == 0)
    throw InputError("the modes, derivatives and snapshots span nothing: raise -modes or give -snapshots that move");
  if (cut.size > set.sigma.size())
    throw InputError("option -basis " + std::to_string(cut.size) + ": the modes, derivatives and snapshots have only " +
                     std::to_string(set.sigma.size()) +
                     " independent directions; lower -basis, or raise -modes or -derivatives");
}

/// Turns the first directions so that UᵀKU is diagonal, and fixes their signs.
void finish(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Full& full, const petsc::Tall& R,
            const petsc::ConstTallRef& directions, BasisResult& result) {
  RitzPairs pairs = rayleigh_ritz(full.stiffness, full.mass, R, directions);
  if (pairs.vectors.cols() < directions.cols())
    throw NumericalError("the basis lost " + std::to_string(directions.cols() - pairs.vectors.cols()) +
                         " of its directions to rounding; lower -basis");
  const auto W = fixed_vectors(mesh, dofs, largest_group(pairs.values), sign_stream);
  make_canonical(full.mass, pairs.values, W, pairs.vectors);
  const Eigen::MatrixXd gram = petsc::inner(mesh.comm, pairs.vectors, petsc::multiply(full.mass, pairs.vectors));
  const double error = (gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff();
  if (!(error <= orthonormality_gate))
    throw NumericalError("the basis is not orthonormal: max |UᵀMU - I| is " + std::to_string(error));
  result.figures.emplace_back("basis_orthonormality", error);
  result.U = std::move(pairs.vectors);
  result.reduction.stiffness = pairs.values;
}

}  // namespace

BasisResult basis(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Full& full, const ModesResult& modes,
                  const petsc::ConstTallRef& snapshots, const BasisOptions& options, const ModesProgress& progress) {
  const Entering in = entering(modes, options.modes);
  if (options.derivatives > in.values.size())
    throw InputError("option -derivatives " + std::to_string(options.derivatives) + ": only " +
                     std::to_string(in.values.size()) + " flexible modes enter the basis; lower -derivatives");
  BasisResult result;
  Principal set;
  add_modes(full.mass, in.values, in.vectors, options.cut, set);
  if (options.derivatives > 0) add_derivatives(mesh, dofs, full, modes, in, options, progress, set, result);
  add_snapshots(full, snapshots, options.cut, set);
  require_enough(set, options.cut);

  const int r = kept(set, options.cut);
  result.reduction.singular_values = set.sigma;
  result.reduction.discarded = std::sqrt(set.discarded + set.sigma.tail(set.sigma.size() - r).squaredNorm());
  finish(mesh, dofs, full, rigid_modes(modes), set.Q.leftCols(r), result);
  return result;
}

}  // namespace ritz::stages
