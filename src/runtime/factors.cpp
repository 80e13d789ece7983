#include "ritz/runtime/factors.hpp"

#include <utility>

namespace ritz::runtime {

namespace {

/// In place, with row pivoting. Eigen's own allocates when it is large.
template <class Scalar>
void factor_lu(Matrix<Scalar>& lu, std::vector<Eigen::Index>& swaps) {
  const Eigen::Index n = lu.rows();
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index pivot = 0;
    lu.col(k).tail(n - k).cwiseAbs().maxCoeff(&pivot);
    pivot += k;
    swaps[static_cast<std::size_t>(k)] = pivot;
    if (pivot != k) lu.row(k).swap(lu.row(pivot));
    const Eigen::Index below = n - k - 1;
    lu.col(k).tail(below) /= lu(k, k);
    for (Eigen::Index j = k + 1; j < n; ++j) lu.col(j).tail(below) -= lu(k, j) * lu.col(k).tail(below);
  }
}

}  // namespace

template <class Scalar>
Factors<Scalar> make_factors(Eigen::Index r) {
  return {.cholesky = Eigen::LLT<Matrix<Scalar>>(r),
          .lu = Matrix<Scalar>::Zero(r, r),
          .swaps = std::vector<Eigen::Index>(static_cast<std::size_t>(r))};
}

template <class Scalar>
void factor(const Matrix<Scalar>& matrix, Factors<Scalar>& factors) {
  factors.cholesky.compute(matrix);
  factors.definite = factors.cholesky.info() == Eigen::Success;
  if (factors.definite) return;
  factors.lu = matrix;
  factor_lu(factors.lu, factors.swaps);
}

template <class Scalar>
void solve_in_place(const Factors<Scalar>& factors, Vector<Scalar>& x) {
  if (factors.definite) {
    factors.cholesky.solveInPlace(x);
    return;
  }
  for (Eigen::Index k = 0; k < x.size(); ++k) std::swap(x[k], x[factors.swaps[static_cast<std::size_t>(k)]]);
  factors.lu.template triangularView<Eigen::UnitLower>().solveInPlace(x);
  factors.lu.template triangularView<Eigen::Upper>().solveInPlace(x);
}

template Factors<double> make_factors(Eigen::Index);
template Factors<float> make_factors(Eigen::Index);
template void factor(const Matrix<double>&, Factors<double>&);
template void factor(const Matrix<float>&, Factors<float>&);
template void solve_in_place(const Factors<double>&, Vector<double>&);
template void solve_in_place(const Factors<float>&, Vector<float>&);

}  // namespace ritz::runtime
