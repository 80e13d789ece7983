#include "ritz/runtime/factors.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace ritz::runtime {
namespace {

/// Solves A x = b of a known x; A is symmetric, its eigenvalues 1 ... 3 shifted by `shift`.
template <class Scalar>
void expect_solution(Eigen::Index n, Scalar shift) {
  Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {  // a product of n reflections may be any turn
    const Eigen::VectorXd normal = Eigen::VectorXd::Random(n).normalized();
    turn -= 2 * (turn * normal) * normal.transpose();
  }
  const Matrix<Scalar> Q = turn.cast<Scalar>();
  const Vector<Scalar> eigenvalues = Vector<Scalar>::LinSpaced(n, 1, 3).array() + shift;
  const Matrix<Scalar> A = Q * eigenvalues.asDiagonal() * Q.transpose();
  const Vector<Scalar> expected = Vector<Scalar>::LinSpaced(n, 1, -2);
  auto factors = make_factors<Scalar>(n);
  factor(A, factors);
  Vector<Scalar> x = A * expected;
  solve_in_place(factors, x);
  EXPECT_EQ(factors.definite, eigenvalues.minCoeff() > 0) << n;
  EXPECT_LE((x - expected).norm(), 1000 * std::numeric_limits<Scalar>::epsilon() * expected.norm()) << n;
}

TEST(Factors, SolveOfAnySize) {
  for (const Eigen::Index n : {1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 20, 30, 63}) {
    expect_solution<double>(n, 0);
    expect_solution<float>(n, 0);
    expect_solution<double>(n, -1.3);  // with a negative eigenvalue, by LU
  }
}

}  // namespace
}  // namespace ritz::runtime
