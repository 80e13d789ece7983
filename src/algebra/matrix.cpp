#include "ritz/algebra/matrix.hpp"

namespace ritz::algebra {

std::int64_t rows(const Matrix& A) {
  PetscInt total = 0;
  check(MatGetSize(A, &total, nullptr));
  return total;
}

Eigen::VectorXd diagonal(Mat A) {
  Vector entries;
  const PetscScalar* values = nullptr;
  PetscInt rows = 0;
  check(MatGetLocalSize(A, &rows, nullptr));
  check(MatCreateVecs(A, nullptr, entries.out()));
  check(MatGetDiagonal(A, entries));
  check(VecGetArrayRead(entries, &values));
  Eigen::VectorXd copied = Eigen::Map<const Eigen::VectorXd>(values, rows);
  check(VecRestoreArrayRead(entries, &values));
  return copied;
}

double one_norm(const Matrix& A) {
  PetscReal norm = 0;
  check(MatNorm(A, NORM_INFINITY, &norm));
  return norm;
}

void add(const Matrix& A, double factor, const Matrix& B, Pattern pattern) {
  check(MatAXPY(A, factor, B, pattern == Pattern::same ? SAME_NONZERO_PATTERN : SUBSET_NONZERO_PATTERN));
}

Matrix copy(const Matrix& A) {
  Matrix copied;
  check(MatDuplicate(A, MAT_COPY_VALUES, copied.out()));
  return copied;
}

}  // namespace ritz::algebra
