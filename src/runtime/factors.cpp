#include "ritz/runtime/factors.hpp"

#include <utility>

namespace ritz::runtime {
namespace {

using Eigen::Index;

/// In place, with row pivoting. Eigen's own allocates when it is large.
template <class Scalar>
void factor_lu(Matrix<Scalar>& lu, std::vector<Index>& swaps) {
  const Index n = lu.rows();
  for (Index k = 0; k < n; ++k) {
    Index pivot = 0;
    lu.col(k).tail(n - k).cwiseAbs().maxCoeff(&pivot);
    pivot += k;
    swaps[static_cast<std::size_t>(k)] = pivot;
    if (pivot != k) lu.row(k).swap(lu.row(pivot));
    const Index below = n - k - 1;
    lu.col(k).tail(below) /= lu(k, k);
    for (Index j = k + 1; j < n; ++j) lu.col(j).tail(below) -= lu(k, j) * lu.col(k).tail(below);
  }
}

/// x := (L Lᵀ)⁻¹ x. What takes the time of a small solve is that one unknown waits for another: four are found at a
/// time, in registers and by the reciprocals w of the pivots. What four leave over comes first.
template <class Scalar>
void solve_cholesky(const Matrix<Scalar>& L, const Vector<Scalar>& w, Vector<Scalar>& x) {
  const Index n = x.size(), few = n % 4;
  for (Index k = 0; k < few; ++k) {
    x[k] *= w[k];
    x.tail(n - k - 1) -= x[k] * L.col(k).tail(n - k - 1);
  }
  for (Index k = few; k < n; k += 4) {
    const auto below = [&](Index column) { return L.col(column).tail(n - k - 4); };
    const Scalar a = x[k] * w[k];
    const Scalar b = (x[k + 1] - L(k + 1, k) * a) * w[k + 1];
    const Scalar c = (x[k + 2] - L(k + 2, k) * a - L(k + 2, k + 1) * b) * w[k + 2];
    const Scalar d = (x[k + 3] - L(k + 3, k) * a - L(k + 3, k + 1) * b - L(k + 3, k + 2) * c) * w[k + 3];
    x[k] = a, x[k + 1] = b, x[k + 2] = c, x[k + 3] = d;
    x.tail(n - k - 4) -= (a * below(k) + b * below(k + 1)) + (c * below(k + 2) + d * below(k + 3));
  }
  for (Index k = n - 4; k >= few; k -= 4) {
    const Scalar d = x[k + 3] * w[k + 3];
    const Scalar c = (x[k + 2] - L(k + 3, k + 2) * d) * w[k + 2];
    const Scalar b = (x[k + 1] - L(k + 3, k + 1) * d - L(k + 2, k + 1) * c) * w[k + 1];
    const Scalar a = (x[k] - L(k + 3, k) * d - L(k + 2, k) * c - L(k + 1, k) * b) * w[k];
    x[k] = a, x[k + 1] = b, x[k + 2] = c, x[k + 3] = d;
    for (Index i = 0; i < k; ++i) x[i] -= (L(k, i) * a + L(k + 1, i) * b) + (L(k + 2, i) * c + L(k + 3, i) * d);
  }
  for (Index k = few - 1; k >= 0; --k) {
    x[k] *= w[k];
    x.head(k) -= x[k] * L.row(k).head(k).transpose();
  }
}

}  // namespace

template <class Scalar>
Factors<Scalar> make_factors(Index r) {
  return {.cholesky = Eigen::LLT<Matrix<Scalar>>(r),
          .reciprocals = Vector<Scalar>::Zero(r),
          .lu = Matrix<Scalar>::Zero(r, r),
          .swaps = std::vector<Index>(static_cast<std::size_t>(r))};
}

template <class Scalar>
void factor(const Matrix<Scalar>& matrix, Factors<Scalar>& factors) {
  factors.cholesky.compute(matrix);
  factors.definite = factors.cholesky.info() == Eigen::Success;
  if (factors.definite) {
    factors.reciprocals = factors.cholesky.matrixLLT().diagonal().cwiseInverse();
    return;
  }
  factor_unsymmetric(matrix, factors);
}

template <class Scalar>
void factor_unsymmetric(const Matrix<Scalar>& matrix, Factors<Scalar>& factors) {
  factors.definite = false;
  factors.lu = matrix;
  factor_lu(factors.lu, factors.swaps);
}

template <class Scalar>
void solve_in_place(const Factors<Scalar>& factors, Vector<Scalar>& x) {
  if (factors.definite) return solve_cholesky(factors.cholesky.matrixLLT(), factors.reciprocals, x);
  for (Index k = 0; k < x.size(); ++k) std::swap(x[k], x[factors.swaps[static_cast<std::size_t>(k)]]);
  factors.lu.template triangularView<Eigen::UnitLower>().solveInPlace(x);
  factors.lu.template triangularView<Eigen::Upper>().solveInPlace(x);
}

template Factors<double> make_factors(Index);
template Factors<float> make_factors(Index);
template void factor(const Matrix<double>&, Factors<double>&);
template void factor(const Matrix<float>&, Factors<float>&);
template void factor_unsymmetric(const Matrix<double>&, Factors<double>&);
template void factor_unsymmetric(const Matrix<float>&, Factors<float>&);
template void solve_in_place(const Factors<double>&, Vector<double>&);
template void solve_in_place(const Factors<float>&, Vector<float>&);

}  // namespace ritz::runtime
