#include "ritz/petsc/gram.hpp"

#include <petscsys.h>

#include <petscblaslapack.h>

namespace ritz::petsc {

void add_gram(Eigen::Ref<Eigen::MatrixXd> gram, const Eigen::Ref<const Eigen::MatrixXd>& y) {
  const auto n = static_cast<PetscBLASInt>(gram.rows()), depth = static_cast<PetscBLASInt>(y.cols());
  if (n == 0 || depth == 0) return;
  const auto ldy = static_cast<PetscBLASInt>(y.outerStride()), ldg = static_cast<PetscBLASInt>(gram.outerStride());
  const double one = 1;
  BLASsyrk_("U", "N", &n, &depth, &one, y.data(), &ldy, &one, gram.data(), &ldg);
}

}  // namespace ritz::petsc
