#include "ritz/petsc/accumulate.hpp"

#include <algorithm>
#include <vector>

#include "ritz/petsc/check.hpp"

namespace ritz::petsc {

Tall accumulate(MPI_Comm comm, std::span<const std::int64_t> numbers, const ConstTallRef& values, int owned) {
  const std::vector<PetscInt> where(numbers.begin(), numbers.end());
  Tall sums(owned, values.cols());
  for (Eigen::Index j = 0; j < values.cols(); ++j) {
    Vector v;
    check(VecCreateMPI(comm, owned, PETSC_DETERMINE, v.out()));
    check(VecSetValues(v, static_cast<PetscInt>(where.size()), where.data(), values.col(j).data(), ADD_VALUES));
    check(VecAssemblyBegin(v));
    check(VecAssemblyEnd(v));
    const PetscScalar* entries = nullptr;
    check(VecGetArrayRead(v, &entries));
    std::copy_n(entries, owned, sums.col(j).data());
    check(VecRestoreArrayRead(v, &entries));
  }
  return sums;
}

}  // namespace ritz::petsc
