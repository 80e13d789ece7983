// Sparse matrices built from rows that this rank has counted itself.
#pragma once
#include <vector>

#include "ritz/petsc/handle.hpp"

namespace ritz::petsc {

/// Rows in compressed form; columns ascend within a row.
struct Csr {
  std::vector<PetscInt> starts = {0};
  std::vector<PetscInt> columns;
  std::vector<PetscScalar> values;
};

/// This rank's rows of a square matrix, in two parts of as many rows: columns of this rank, counted from its first row,
/// and columns of other ranks, global.
struct Rows {
  Csr own, other;
};

enum class Definite { semi, positive };

/// A symmetric square matrix with `block` rows a vertex; the rows become its storage. *Collective*.
Matrix symmetric_matrix(MPI_Comm comm, Rows rows, PetscInt block, Definite definite);

/// The rows of a matrix that `symmetric_matrix` made, to be given other values: after that, `renewed`. (Of a matrix on
/// several ranks the columns of `other` are PETSc's own by now; their order is as it was.)
Rows& storage(Mat A);

/// Tells PETSc that the values are new. *Collective*.
void renewed(Mat A);

/// The identity of `size` (a multiple of 3) rows, whole on rank 0: enough for a solver to be set up and so to read its
/// options. *Collective*.
Matrix tiny_identity(MPI_Comm comm, PetscInt size = 3);

}  // namespace ritz::petsc
