#include "ritz/petsc/csr.hpp"

#include "ritz/parallel/comm.hpp"
#include "ritz/petsc/check.hpp"

namespace ritz::petsc {

Matrix symmetric_matrix(MPI_Comm comm, const Csr& rows, PetscInt block, Definite definite) {
  Matrix A;
  const auto local = static_cast<PetscInt>(rows.starts.size() - 1);
  check(MatCreate(comm, A.out()));
  check(MatSetSizes(A, local, local, PETSC_DETERMINE, PETSC_DETERMINE));
  check(MatSetBlockSize(A, block));
  check(MatSetType(A, MATAIJ));
  check(MatSeqAIJSetPreallocationCSR(A, rows.starts.data(), rows.columns.data(), rows.values.data()));
  check(MatMPIAIJSetPreallocationCSR(A, rows.starts.data(), rows.columns.data(), rows.values.data()));
  check(MatSetOption(A, MAT_SYMMETRIC, PETSC_TRUE));
  check(MatSetOption(A, MAT_SYMMETRY_ETERNAL, PETSC_TRUE));
  if (definite == Definite::positive) check(MatSetOption(A, MAT_SPD, PETSC_TRUE));
  return A;
}

Matrix tiny_identity(MPI_Comm comm) {
  Csr rows;
  for (PetscInt i = 0; parallel::rank(comm) == 0 && i < 3; ++i) {
    rows.columns.push_back(i);
    rows.values.push_back(1);
    rows.starts.push_back(i + 1);
  }
  return symmetric_matrix(comm, rows, 3, Definite::positive);
}

double stored_bytes(Mat A) {
  MatInfo info;
  check(MatGetInfo(A, MAT_LOCAL, &info));
  return info.memory;
}

}  // namespace ritz::petsc
