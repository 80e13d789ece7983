#include "ritz/stages/principal.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <utility>

#include "ritz/algebra/dense.hpp"
#include "ritz/algebra/handle.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double margin = 1e-3;  ///< of the σ at the cut: what is dropped while the set still grows
constexpr double small_enough_for_jacobi = 1e-9;
constexpr double independent = 1e-13;  ///< of σ₁: rounding makes smaller directions up

/// The columns scaled to unit length: only for conditioning, the scale does not enter the decomposition.
algebra::Tall normalised(MPI_Comm comm, const algebra::ConstTallRef& block) {
  const Eigen::VectorXd norms = algebra::column_norms(comm, block);
  return block * norms.unaryExpr([](double n) { return n > 0 ? 1 / n : 0; }).asDiagonal();
}

/// Singular values and left vectors by Jacobi's rotations: slower, and right relative to each σ.
algebra::SingularVectors by_rotations(const MatrixXd& small) {
  const Eigen::JacobiSVD<MatrixXd> svd(small, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.singularValues(), svd.matrixU()};
}

}  // namespace

double negligible(const Principal& set, const Cut& cut) {
  if (set.sigma.size() == 0) return 0;
  const double floor = independent * set.sigma[0];
  if (cut.size == 0) return std::max(floor, margin * cut.tolerance * set.sigma[0]);
  return cut.size <= set.sigma.size() ? std::max(floor, margin * set.sigma[cut.size - 1]) : floor;
}

double dispensable(const Principal& set, const Cut& cut) {
  return cut.size == 0 && set.sigma.size() > 0 ? cut.tolerance / 2 * set.sigma[0] : negligible(set, cut);
}

void add(const algebra::Matrix& M, Principal& set, const algebra::ConstTallRef& block, const Cut& cut) {
  if (block.cols() == 0) return;
  const MPI_Comm comm = algebra::comm_of(M);
  const Index old = set.sigma.size();
  if (old == 0) set.Q.resize(block.rows(), 0);
  algebra::Tall fresh = normalised(comm, block);
  const int width = algebra::orthonormalise(M, set.Q, fresh);
  if (old + width == 0) return;  // nothing moves
  algebra::Tall both(block.rows(), old + width);
  both << set.Q, fresh.leftCols(width);

  MatrixXd small = MatrixXd::Zero(both.cols(), old + block.cols());
  small.topLeftCorner(old, old) = set.sigma.asDiagonal();
  small.rightCols(block.cols()) = algebra::inner(comm, both, algebra::multiply(M, block));
  // What orthonormalisation took for dependent is left out as well.
  const algebra::Tall rest = block - algebra::combine(both, small.rightCols(block.cols()));
  set.discarded += std::max(0.0, algebra::inner(comm, rest, algebra::multiply(M, rest)).trace());
  const bool graded = old == 0 || negligible(set, cut) < small_enough_for_jacobi * set.sigma[0];
  auto [sigma, left] = graded ? by_rotations(small) : algebra::left_singular_vectors(small);
  set.sigma = std::move(sigma);
  const double least = negligible(set, cut);
  const Index count = (set.sigma.array() > least).count();
  set.discarded += set.sigma.tail(set.sigma.size() - count).squaredNorm();
  set.Q = algebra::combine(both, left.leftCols(count));
  set.sigma.conservativeResize(count);
}

int kept(const Principal& set, const Cut& cut) {
  if (cut.size > 0) return std::min<int>(cut.size, static_cast<int>(set.sigma.size()));
  return set.sigma.size() == 0 ? 0 : static_cast<int>((set.sigma.array() > cut.tolerance * set.sigma[0]).count());
}

}  // namespace ritz::stages
