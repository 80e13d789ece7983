#include "ritz/petsc/csr.hpp"

#include <memory>
#include <utility>

#include "ritz/parallel/comm.hpp"
#include "ritz/petsc/check.hpp"

namespace ritz::petsc {
namespace {

/// What a matrix's numbers stand in: this rank's rows, columns of its own and of other ranks apart.
struct Storage {
  Csr own, other;
};

/// Moves the columns outside [first, first + rows) to `other`; those of `own` are then counted from `first`.
void split(Storage& storage, PetscInt first) {
  Csr& own = storage.own;
  const auto rows = own.starts.size() - 1;
  std::size_t from = 0, to = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    for (; from < static_cast<std::size_t>(own.starts[row + 1]); ++from) {
      const PetscInt column = own.columns[from] - first;
      if (column >= 0 && column < static_cast<PetscInt>(rows)) {
        own.columns[to] = column;
        own.values[to++] = own.values[from];
      } else {
        storage.other.columns.push_back(own.columns[from]);
        storage.other.values.push_back(own.values[from]);
      }
    }
    own.starts[row + 1] = static_cast<PetscInt>(to);
    storage.other.starts.push_back(static_cast<PetscInt>(storage.other.columns.size()));
  }
}

PetscErrorCode destroy_storage(void* storage) {
  delete static_cast<Storage*>(storage);
  return 0;
}

/// Lets A own the storage.
void keep(Mat A, std::unique_ptr<Storage> storage) {
  Container container;
  check(PetscContainerCreate(PetscObjectComm(reinterpret_cast<PetscObject>(A)), container.out()));
  check(PetscContainerSetPointer(container, storage.release()));
  check(PetscContainerSetUserDestroy(container, destroy_storage));
  check(PetscObjectCompose(reinterpret_cast<PetscObject>(A), "ritz_storage",
                           reinterpret_cast<PetscObject>(container.get())));
}

}  // namespace

Matrix symmetric_matrix(MPI_Comm comm, Csr rows, PetscInt block, Definite definite) {
  Matrix A;
  const auto local = static_cast<PetscInt>(rows.starts.size() - 1);
  auto storage = std::make_unique<Storage>(Storage{std::move(rows), {}});
  Csr &own = storage->own, &other = storage->other;
  if (parallel::size(comm) == 1) {
    check(MatCreateSeqAIJWithArrays(comm, local, local, own.starts.data(), own.columns.data(), own.values.data(),
                                    A.out()));
  } else {
    split(*storage, static_cast<PetscInt>(parallel::sum_before(comm, local)));
    check(MatCreateMPIAIJWithSplitArrays(comm, local, local, PETSC_DETERMINE, PETSC_DETERMINE, own.starts.data(),
                                         own.columns.data(), own.values.data(), other.starts.data(),
                                         other.columns.data(), other.values.data(), A.out()));
  }
  keep(A, std::move(storage));
  check(MatSetBlockSize(A, block));
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
  return symmetric_matrix(comm, std::move(rows), 3, Definite::positive);
}

}  // namespace ritz::petsc
