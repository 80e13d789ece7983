// Sparse matrices that are built from rows whose pattern this rank has computed.
#pragma once
#include <vector>

#include "ritz/algebra/handle.hpp"

namespace ritz::algebra {

/// Compressed sparse rows; columns ascend within a row.
struct Csr {
  std::vector<PetscInt> starts = {0};
  std::vector<PetscInt> columns;
  std::vector<PetscScalar> values;
};

/// This rank's rows of a square matrix, in two parts with the same number of rows: `own` has the columns of this rank,
/// counted from its first row; `other` has the columns of other ranks, by global number.
struct Rows {
  Csr own, other;
};

enum class Definite { semi, positive };

/// *Collective*. A symmetric square matrix with `block` rows for each vertex. The rows become its storage.
Matrix symmetric_matrix(MPI_Comm comm, Rows rows, PetscInt block, Definite definite);

/// The rows of a matrix made by `symmetric_matrix`, whose values may be changed; call `renewed` afterwards. (On several
/// ranks PETSc has renumbered the columns of `other`; their order is unchanged.)
Rows& storage(Mat A);

/// *Collective*. Tells PETSc that the values have changed.
void renewed(Mat A);

/// *Collective*. The identity with `size` rows (a multiple of 3), all on rank 0: enough to set a solver up, so that it
/// reads its options.
Matrix tiny_identity(MPI_Comm comm, PetscInt size = 3);

}  // namespace ritz::algebra
