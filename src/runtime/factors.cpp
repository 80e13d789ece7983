#include "ritz/runtime/factors.hpp"

namespace ritz::runtime {

template <class Scalar>
Factors<Scalar> make_factors(Eigen::Index r) {
  return {.cholesky = Eigen::LLT<Matrix<Scalar>>(r), .lu = Eigen::PartialPivLU<Matrix<Scalar>>(r)};
}

template <class Scalar>
void factor(const Matrix<Scalar>& matrix, Factors<Scalar>& factors) {
  factors.cholesky.compute(matrix);
  factors.definite = factors.cholesky.info() == Eigen::Success;
  if (!factors.definite) factors.lu.compute(matrix);
}

template <class Scalar>
void solve_in_place(const Factors<Scalar>& factors, Vector<Scalar>& x) {
  if (factors.definite) {
    factors.cholesky.solveInPlace(x);
    return;
  }
  factors.lu.permutationP().applyThisOnTheLeft(x);
  factors.lu.matrixLU().template triangularView<Eigen::UnitLower>().solveInPlace(x);
  factors.lu.matrixLU().template triangularView<Eigen::Upper>().solveInPlace(x);
}

template Factors<double> make_factors(Eigen::Index);
template Factors<float> make_factors(Eigen::Index);
template void factor(const Matrix<double>&, Factors<double>&);
template void factor(const Matrix<float>&, Factors<float>&);
template void solve_in_place(const Factors<double>&, Vector<double>&);
template void solve_in_place(const Factors<float>&, Vector<float>&);

}  // namespace ritz::runtime
