#include "ritz/algebra/write_matrix.hpp"

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/handle.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/ranked_text.hpp"

namespace ritz::algebra {
namespace {

IndexSet rows_of(MPI_Comm comm, const std::vector<std::int64_t>& order) {
  const std::vector<PetscInt> rows(order.begin(), order.end());
  IndexSet set;
  check(ISCreateGeneral(comm, static_cast<PetscInt>(rows.size()), rows.data(), PETSC_COPY_VALUES, set.out()));
  return set;
}

Matrix reordered(Mat A, const std::vector<std::int64_t>& order) {
  const IndexSet rows = rows_of(comm_of(A), order);
  Matrix B;
  check(MatCreateSubMatrix(A, rows, rows, MAT_INITIAL_MATRIX, B.out()));
  return B;
}

/// Column by column: PETSc's own submatrix of a dense matrix fails where a rank has no rows.
Tall reordered(MPI_Comm comm, Tall& columns, const std::vector<std::int64_t>& order) {
  Tall rows(static_cast<Eigen::Index>(order.size()), columns.cols());
  const IndexSet from = rows_of(comm, order);
  Vector before, after;
  check(VecCreateMPIWithArray(comm, 1, static_cast<PetscInt>(columns.rows()), PETSC_DECIDE, nullptr, before.out()));
  check(VecCreateMPIWithArray(comm, 1, static_cast<PetscInt>(order.size()), PETSC_DECIDE, nullptr, after.out()));
  Scatter scatter;
  check(VecScatterCreate(before, from, after, nullptr, scatter.out()));
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    check(VecPlaceArray(before, columns.col(j).data()));
    check(VecPlaceArray(after, rows.col(j).data()));
    check(VecScatterBegin(scatter, before, after, INSERT_VALUES, SCATTER_FORWARD));
    check(VecScatterEnd(scatter, before, after, INSERT_VALUES, SCATTER_FORWARD));
    check(VecResetArray(before));
    check(VecResetArray(after));
  }
  return rows;
}

void write_binary(const std::filesystem::path& path, MPI_Comm comm, Mat A) {
  Viewer viewer;
  check(PetscViewerBinaryOpen(comm, path.c_str(), FILE_MODE_WRITE, viewer.out()));
  check(PetscViewerBinarySetSkipInfo(viewer, PETSC_TRUE));
  check(MatView(A, viewer));
}

/// PETSc's own viewer writes six digits.
void write_sparse_text(const std::filesystem::path& path, MPI_Comm comm, Mat A) {
  PetscInt size = 0, first = 0, last = 0;
  MatInfo info;
  check(MatGetSize(A, &size, nullptr));
  check(MatGetOwnershipRange(A, &first, &last));
  check(MatGetInfo(A, MAT_GLOBAL_SUM, &info));
  parallel::RankedText out(comm, path);
  const auto n = std::to_string(size);
  out.header("%%MatrixMarket matrix coordinate real general\n" + n + " " + n + " " +
             std::to_string(static_cast<std::int64_t>(info.nz_used)) + "\n");
  for (PetscInt i = first; i < last; ++i) {
    PetscInt count = 0;
    const PetscInt* columns = nullptr;
    const PetscScalar* values = nullptr;
    check(MatGetRow(A, i, &count, &columns, &values));
    for (PetscInt k = 0; k < count; ++k) {
      out.add(i + 1, ' ');
      out.add(columns[k] + 1, ' ');
      out.add(values[k], '\n');
    }
    check(MatRestoreRow(A, i, &count, &columns, &values));
  }
  out.end_part();
  out.close();
}

void write_dense_text(const std::filesystem::path& path, MPI_Comm comm, const Tall& rows) {
  parallel::RankedText out(comm, path);
  out.header("%%MatrixMarket matrix array real general\n" +
             std::to_string(parallel::sum(comm, std::int64_t{rows.rows()})) + " " + std::to_string(rows.cols()) + "\n");
  for (Eigen::Index j = 0; j < rows.cols(); ++j) {
    for (Eigen::Index i = 0; i < rows.rows(); ++i) out.add(rows(i, j), '\n');
    out.end_part();
  }
  out.close();
}

}  // namespace

void write_matrix(const std::filesystem::path& path, Mat A, const std::vector<std::int64_t>& order,
                  MatrixFormat format) {
  const MPI_Comm comm = comm_of(A);
  const Matrix B = reordered(A, order);
  format == MatrixFormat::matrixmarket ? write_sparse_text(path, comm, B) : write_binary(path, comm, B);
}

void write_columns(const std::filesystem::path& path, MPI_Comm comm, Tall columns,
                   const std::vector<std::int64_t>& order, MatrixFormat format) {
  Tall rows = reordered(comm, columns, order);
  format == MatrixFormat::matrixmarket ? write_dense_text(path, comm, rows)
                                       : write_binary(path, comm, as_dense(comm, rows));
}

}  // namespace ritz::algebra
