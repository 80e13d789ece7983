#include "ritz/stages/inverse.hpp"

#include <cstdio>
#include <limits>

#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/petsc/handle.hpp"

namespace ritz::stages {
namespace {

constexpr double tolerance = 1e-11;
constexpr int most_iterations = 500;

Eigen::ArrayXd dots(MPI_Comm comm, const petsc::Tall& a, const petsc::Tall& b) {
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

Solved solve(const Matrices& matrices, const Inverse& inverse, const petsc::Tall& rigid, double norm_K,
             const petsc::ConstTallRef& b) {
  const MPI_Comm comm = petsc::comm_of(matrices.stiffness);
  const petsc::Tall massive = petsc::multiply(matrices.mass, rigid);
  petsc::Tall r = b, z(b.rows(), b.cols());
  if (rigid.cols() > 0) petsc::subtract(r, massive, petsc::inner(comm, rigid, r));
  const auto precondition = [&] {
    inverse(r, z);
    if (rigid.cols() > 0) petsc::subtract(z, rigid, petsc::inner(comm, massive, z));
  };
  const Eigen::ArrayXd loads = petsc::column_norms(comm, r).array();
  Solved solved{petsc::Tall::Zero(b.rows(), b.cols())};
  petsc::Tall p = petsc::Tall::Zero(b.rows(), b.cols());
  Eigen::ArrayXd last = Eigen::ArrayXd::Ones(b.cols());
  for (;; ++solved.iterations) {
    const Eigen::ArrayXd sizes = petsc::column_norms(comm, r).array();
    const Eigen::ArrayXd floor =
        10 * std::numeric_limits<double>::epsilon() * norm_K * petsc::column_norms(comm, solved.x).array();
    const Eigen::ArrayXd open = (sizes > (tolerance * loads).max(floor)).cast<double>();
    solved.residual = quotient(sizes, loads).maxCoeff();
    if (!(open.maxCoeff() > 0) && sizes.isFinite().all()) return solved;
    if (solved.iterations == most_iterations || !sizes.isFinite().all()) fail(solved.residual);
    precondition();
    const Eigen::ArrayXd rz = dots(comm, r, z);
    const Eigen::ArrayXd beta = solved.iterations == 0 ? Eigen::ArrayXd::Zero(b.cols()) : quotient(rz, last);
    p = z + p * beta.matrix().asDiagonal();
    last = rz;
    const petsc::Tall kp = petsc::multiply(matrices.stiffness, p);
    const Eigen::ArrayXd alpha = open * quotient(rz, dots(comm, p, kp));
    solved.x += p * alpha.matrix().asDiagonal();
    r -= kp * alpha.matrix().asDiagonal();
  }
}

}  // namespace ritz::stages
