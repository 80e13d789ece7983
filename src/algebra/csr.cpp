#include "ritz/algebra/csr.hpp"

#include <memory>
#include <utility>

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/handle.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::algebra {
namespace {

constexpr const char* storage_name = "ritz_storage";

PetscErrorCode destroy_storage(void* storage) {
  delete static_cast<Rows*>(storage);
  return 0;
}

/// Lets A own the storage.
void keep(Mat A, std::unique_ptr<Rows> storage) {
  Container container;
  check(PetscContainerCreate(comm_of(A), container.out()));
  check(PetscContainerSetPointer(container, storage.release()));
  check(PetscContainerSetUserDestroy(container, destroy_storage));
  check(PetscObjectCompose(reinterpret_cast<PetscObject>(A), storage_name,
                           reinterpret_cast<PetscObject>(container.get())));
}

}  // namespace

Matrix symmetric_matrix(MPI_Comm comm, Rows rows, PetscInt block, Definite definite) {
  Matrix A;
  auto storage = std::make_unique<Rows>(std::move(rows));
  Csr &own = storage->own, &other = storage->other;
  const auto local = static_cast<PetscInt>(own.starts.size() - 1);
  if (parallel::size(comm) == 1)
    check(MatCreateSeqAIJWithArrays(comm, local, local, own.starts.data(), own.columns.data(), own.values.data(),
                                    A.out()));
  else
    check(MatCreateMPIAIJWithSplitArrays(comm, local, local, PETSC_DETERMINE, PETSC_DETERMINE, own.starts.data(),
                                         own.columns.data(), own.values.data(), other.starts.data(),
                                         other.columns.data(), other.values.data(), A.out()));
  keep(A, std::move(storage));
  check(MatSetBlockSize(A, block));
  check(MatSetOption(A, MAT_SYMMETRIC, PETSC_TRUE));
  check(MatSetOption(A, MAT_SYMMETRY_ETERNAL, PETSC_TRUE));
  if (definite == Definite::positive) check(MatSetOption(A, MAT_SPD, PETSC_TRUE));
  return A;
}

Rows& storage(Mat A) {
  PetscObject container = nullptr;
  void* rows = nullptr;
  check(PetscObjectQuery(reinterpret_cast<PetscObject>(A), storage_name, &container));
  check(PetscContainerGetPointer(reinterpret_cast<PetscContainer>(container), &rows));
  return *static_cast<Rows*>(rows);
}

void renewed(Mat A) {
  check(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
}

Matrix tiny_identity(MPI_Comm comm, PetscInt size) {
  Rows rows;
  for (PetscInt i = 0; parallel::rank(comm) == 0 && i < size; ++i) {
    rows.own.columns.push_back(i);
    rows.own.values.push_back(1);
    rows.own.starts.push_back(i + 1);
    rows.other.starts.push_back(0);
  }
  return symmetric_matrix(comm, std::move(rows), 3, Definite::positive);
}

}  // namespace ritz::algebra
