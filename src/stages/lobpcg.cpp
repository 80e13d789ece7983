#include "ritz/stages/lobpcg.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "ritz/algebra/dense.hpp"
#include "ritz/algebra/handle.hpp"

namespace ritz::stages {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double dependent = 1e-12;  ///< squared size of a direction that the others hold already
constexpr int refreshing = 5;        ///< iterations between two clean-ups

/// Coefficients of the next directions: the part of these columns of C that does not lie along the old X (the first
/// rows), made orthonormal and orthogonal to all of C.
MatrixXd directions(const MatrixXd& C, const std::vector<Index>& columns) {
  MatrixXd D = C(Eigen::all, columns);
  D.topRows(C.cols()).setZero();
  D = D * D.colwise().norm().cwiseMax(std::numeric_limits<double>::min()).cwiseInverse().asDiagonal();
  for (int pass = 0; pass < 2; ++pass) D -= C * (C.transpose() * D);
  const auto [values, vectors] = algebra::symmetric_eigen(D.transpose() * D);
  const Index rank = (values.array() > dependent * values.tail(1)[0]).count();
  return D * vectors.rightCols(rank) * values.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// Takes rounding out of X and P.
void refresh(const algebra::Matrix& M, const algebra::ConstTallRef& locked, algebra::Tall& X, algebra::Tall& P) {
  algebra::Tall x = X;
  if (algebra::orthonormalise(M, locked, x) == X.cols()) X = x;
  P.conservativeResize(Eigen::NoChange, algebra::orthonormalise(M, side_by_side(locked, X), P));
}

}  // namespace

LobpcgResult lobpcg(const algebra::Matrix& K, const algebra::Matrix& M, double norm_K,
                    const BlockPreconditioner& precondition, const algebra::ConstTallRef& locked,
                    const algebra::ConstTallRef& start, const LobpcgOptions& options, const LobpcgProgress& progress) {
  const MPI_Comm comm = algebra::comm_of(K);
  RitzPairs x = rayleigh_ritz(K, M, locked, start);
  algebra::Tall P(start.rows(), 0);
  LobpcgResult result;
  double best = std::numeric_limits<double>::infinity();
  for (int waited = 0; result.iterations < options.iterations && waited < options.patience; ++result.iterations) {
    const Index wanted = std::min<Index>(options.wanted, x.values.size());
    const Residuals r = residuals(K, M, norm_K, x);
    const Eigen::ArrayXd excess = r.relative.array() / r.gate.array();
    const auto met = [&](Index j) { return excess[j] <= options.fraction; };
    result.converged = 0;
    while (result.converged < wanted && met(result.converged)) ++result.converged;
    progress(result.converged, static_cast<int>(wanted));
    if (result.converged == wanted) break;
    const double sum = excess.head(wanted).max(options.fraction).log().sum();
    waited = sum < best - 0.01 ? 0 : waited + 1;
    best = std::min(best, sum);

    std::vector<Index> active;
    for (Index j = 0; j < x.values.size(); ++j)
      if (j >= wanted || !met(j)) active.push_back(j);
    algebra::Tall W(start.rows(), static_cast<Index>(active.size()));
    precondition(r.vectors(Eigen::all, active), W);

    if (result.iterations % refreshing == refreshing - 1) refresh(M, locked, x.vectors, P);
    const algebra::Tall XP = side_by_side(x.vectors, P);
    W.conservativeResize(Eigen::NoChange, algebra::orthonormalise(M, side_by_side(locked, XP), W));
    const algebra::Tall S = side_by_side(XP, W);
    const MatrixXd G = algebra::inner(comm, S, algebra::multiply(K, S));
    const auto [values, vectors] = algebra::symmetric_eigen((G + G.transpose()) / 2);
    const Index kept = x.values.size();
    const MatrixXd C = vectors.leftCols(kept);
    P = algebra::combine(S, directions(C, active));
    x = {values.head(kept), algebra::combine(S, C)};
  }
  const Index count = std::min<Index>(options.wanted, x.values.size());
  result.pairs = {x.values.head(count), x.vectors.leftCols(count)};
  return result;
}

}  // namespace ritz::stages
