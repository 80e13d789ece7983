#include "ritz/stages/inverse.hpp"

#include <cstdio>
#include <limits>

#include "ritz/algebra/handle.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::stages {
namespace {

constexpr int most_iterations = 500;

Eigen::ArrayXd dots(MPI_Comm comm, const algebra::Tall& a, const algebra::Tall& b) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(1, a.cols());
  if (a.rows() > 0) sums = a.cwiseProduct(b).colwise().sum();
  parallel::sum_in_place(comm, sums);
  return sums.transpose().array();
}

/// a / b, and 0 where a column has nothing left to do.
Eigen::ArrayXd quotient(const Eigen::ArrayXd& a, const Eigen::ArrayXd& b) { return (b > 0).select(a / b, 0); }

[[noreturn]] void fail(double residual) {
  throw NumericalError(formatted("solving with K did not converge: relative residual %.2e after %d iterations",
                                 residual, most_iterations),
                       Reason::iterative_solver_failed);
}

}  // namespace

Solved solve(const Matrices& matrices, const Inverse& inverse, const algebra::Tall& rigid, double norm_K,
             const algebra::ConstTallRef& b, double tolerance) {
  const MPI_Comm comm = algebra::comm_of(matrices.stiffness);
  const algebra::Tall massive = algebra::multiply(matrices.mass, rigid);
  algebra::Tall r = b, z(b.rows(), b.cols());
  if (rigid.cols() > 0) algebra::subtract(r, massive, algebra::inner(comm, rigid, r));
  const auto precondition = [&] {
    inverse(r, z);
    if (rigid.cols() > 0) algebra::subtract(z, rigid, algebra::inner(comm, massive, z));
  };
  const Eigen::ArrayXd loads = algebra::column_norms(comm, r).array();
  Solved solved{algebra::Tall::Zero(b.rows(), b.cols())};
  algebra::Tall p = algebra::Tall::Zero(b.rows(), b.cols());
  Eigen::ArrayXd last = Eigen::ArrayXd::Ones(b.cols());
  for (;; ++solved.iterations) {
    const Eigen::ArrayXd sizes = algebra::column_norms(comm, r).array();
    const Eigen::ArrayXd floor =
        10 * std::numeric_limits<double>::epsilon() * norm_K * algebra::column_norms(comm, solved.x).array();
    const Eigen::ArrayXd open = (sizes > (tolerance * loads).max(floor)).cast<double>();
    solved.residual = quotient(sizes, loads).maxCoeff();
    if (!(open.maxCoeff() > 0) && sizes.isFinite().all()) return solved;
    if (solved.iterations == most_iterations || !sizes.isFinite().all()) fail(solved.residual);
    precondition();
    const Eigen::ArrayXd rz = dots(comm, r, z);
    const Eigen::ArrayXd beta = solved.iterations == 0 ? Eigen::ArrayXd::Zero(b.cols()) : quotient(rz, last);
    p = z + p * beta.matrix().asDiagonal();
    last = rz;
    const algebra::Tall kp = algebra::multiply(matrices.stiffness, p);
    const Eigen::ArrayXd alpha = open * quotient(rz, dots(comm, p, kp));
    solved.x += p * alpha.matrix().asDiagonal();
    r -= kp * alpha.matrix().asDiagonal();
  }
}

}  // namespace ritz::stages
