#include "ritz/stages/rayleigh_ritz.hpp"

#include <limits>

#include "ritz/petsc/check.hpp"
#include "ritz/petsc/dense.hpp"
#include "ritz/petsc/handle.hpp"

namespace ritz::stages {

RitzPairs rayleigh_ritz(Mat K, Mat M, const petsc::ConstTallRef& against, petsc::Tall x) {
  const int kept = petsc::orthonormalise(M, against, x);
  const auto basis = x.leftCols(kept);
  const Eigen::MatrixXd product = petsc::inner(petsc::comm_of(K), basis, petsc::multiply(K, basis));
  auto [values, vectors] = petsc::symmetric_eigen((product + product.transpose()) / 2);
  return {std::move(values), petsc::combine(basis, vectors)};
}

double one_norm(Mat A) {
  PetscReal norm = 0;
  petsc::check(MatNorm(A, NORM_INFINITY, &norm));
  return norm;
}

Residuals residuals(Mat K, Mat M, double norm_K, const RitzPairs& pairs) {
  const MPI_Comm comm = petsc::comm_of(K);
  const petsc::Tall mx = petsc::multiply(M, pairs.vectors);
  petsc::Tall r = petsc::multiply(K, pairs.vectors);
  r -= mx * pairs.values.asDiagonal();
  const Eigen::ArrayXd scale = pairs.values.array().abs() * petsc::column_norms(comm, mx).array();
  const Eigen::ArrayXd floor =
      10 * std::numeric_limits<double>::epsilon() * norm_K * petsc::column_norms(comm, pairs.vectors).array() / scale;
  return {petsc::column_norms(comm, r).array() / scale, floor.max(residual_gate), std::move(r)};
}

}  // namespace ritz::stages
