#include "ritz/petsc/multigrid.hpp"

#include <algorithm>
#include <vector>

#include "ritz/petsc/check.hpp"

namespace ritz::petsc {
namespace {

MPI_Comm comm_of(Mat A) { return PetscObjectComm(reinterpret_cast<PetscObject>(A)); }

/// Tells GAMG what the coarse levels must represent.
void attach(Mat A, const ConstTallRef& columns) {
  std::vector<Vector> owned(static_cast<std::size_t>(columns.cols()));
  for (std::size_t j = 0; j < owned.size(); ++j) {
    const auto column = columns.col(static_cast<Eigen::Index>(j));
    PetscScalar* values = nullptr;
    check(MatCreateVecs(A, owned[j].out(), nullptr));
    check(VecGetArrayWrite(owned[j], &values));
    std::copy_n(column.data(), column.size(), values);
    check(VecRestoreArrayWrite(owned[j], &values));
    for (std::size_t i = 0; i < j; ++i) {
      PetscScalar dot = 0;
      check(VecDot(owned[j], owned[i], &dot));
      check(VecAXPY(owned[j], -dot, owned[i]));
    }
    check(VecNormalize(owned[j], nullptr));
  }
  const std::vector<Vec> list(owned.begin(), owned.end());
  NullSpace space;
  check(MatNullSpaceCreate(comm_of(A), PETSC_FALSE, static_cast<PetscInt>(list.size()), list.data(), space.out()));
  check(MatSetNearNullSpace(A, space));
}

}  // namespace

Multigrid::Multigrid(Mat A, const ConstTallRef& near_null, const std::string& prefix) : A_(A) {
  attach(A, near_null);
  check(PCCreate(comm_of(A), cycle_.out()));
  check(PCSetOptionsPrefix(cycle_, prefix.c_str()));
  check(PCSetType(cycle_, PCGAMG));
  PetscReal threshold = 0.01;
  check(PCGAMGSetThreshold(cycle_, &threshold, 1));
  check(PCSetOperators(cycle_, A, A));
  check(PCSetFromOptions(cycle_));
  check(PCSetUp(cycle_));
}

void Multigrid::apply(const ConstTallRef& r, TallRef z) const {
  apply_to_columns(A_, r, z, [&](Vec from, Vec to) { check(PCApply(cycle_, from, to)); });
}

}  // namespace ritz::petsc
