// Written matrices, read again by a parser of this test's own, have the order asked for on any number of ranks.
#include "ritz/algebra/write_matrix.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "algebra/chain.hpp"
#include "support/shared_folder.hpp"

namespace ritz::algebra {
namespace {

using namespace test;

constexpr PetscInt order_of_matrix = 9;

/// MatrixMarket: "array" lists all numbers by columns, "coordinate" row, column, value; symmetric ones half of them.
Eigen::MatrixXd read_matrix_market(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  const bool coordinate = line.find("coordinate") != line.npos, symmetric = line.find("symmetric") != line.npos;
  while (in.peek() == '%') std::getline(in, line);
  Eigen::Index rows = 0, columns = 0, entries = 0;
  in >> rows >> columns;
  if (coordinate) in >> entries;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(rows, columns);
  if (!coordinate)
    for (Eigen::Index i = 0; i < A.size(); ++i) in >> A.data()[i];
  for (Eigen::Index e = 0; e < entries; ++e) {
    Eigen::Index i = 0, j = 0;
    in >> i >> j;
    in >> A(i - 1, j - 1);
    if (symmetric) A(j - 1, i - 1) = A(i - 1, j - 1);
  }
  EXPECT_TRUE(in.good()) << path;
  return A;
}

/// The reverse of the old order, in shares that are not those of the old rows.
std::vector<std::int64_t> reversed() {
  const PetscInt ranks = parallel::size(world), first = order_of_matrix * parallel::rank(world) / ranks;
  std::vector<std::int64_t> order;
  for (PetscInt i = first; i < order_of_matrix * (parallel::rank(world) + 1) / ranks; ++i)
    order.push_back(order_of_matrix - 1 - i);
  return order;
}

/// K with numbers that tell its entries apart.
Matrix labelled(Eigen::MatrixXd& whole) {
  Matrix A = tridiagonal(order_of_matrix, 2, -1);
  const Share rows = my_rows(order_of_matrix);
  const auto value = [](PetscInt i, PetscInt j) { return 1.0 / 3 + 100 * std::min(i, j) + std::max(i, j); };
  whole.setZero(order_of_matrix, order_of_matrix);
  for (PetscInt i = 0; i < order_of_matrix; ++i)
    for (PetscInt j = std::max(0, i - 1); j <= std::min(order_of_matrix - 1, i + 1); ++j) {
      whole(i, j) = value(i, j);
      if (i >= rows.first && i < rows.first + rows.count) MatSetValue(A, i, j, value(i, j), INSERT_VALUES);
    }
  MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY);
  MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY);
  return A;
}

TEST(WriteMatrix, SparseInAnotherOrder) {
  const ritz::test::SharedFolder folder;
  Eigen::MatrixXd whole;
  const Matrix A = labelled(whole);
  write_matrix(folder / "K.mtx", A, reversed(), MatrixFormat::matrixmarket);
  const auto read = read_matrix_market(folder / "K.mtx");
  ASSERT_EQ(read.rows(), order_of_matrix);
  EXPECT_LE((read - whole.reverse()).cwiseAbs().maxCoeff(), 1e-12 * whole.maxCoeff());
}

TEST(WriteMatrix, TallInAnotherOrder) {
  const ritz::test::SharedFolder folder;
  const auto whole = whole_random(order_of_matrix, 4, 1);
  write_columns(folder / "U.mtx", world, my_part(whole), reversed(), MatrixFormat::matrixmarket);
  const auto read = read_matrix_market(folder / "U.mtx");
  ASSERT_EQ(read.rows(), order_of_matrix);
  ASSERT_EQ(read.cols(), 4);
  EXPECT_LE((read - whole.colwise().reverse()).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(WriteMatrix, BinaryComesBackThroughPetsc) {
  const ritz::test::SharedFolder folder;
  Eigen::MatrixXd whole;
  const Matrix A = labelled(whole);
  write_matrix(folder / "K.bin", A, reversed(), MatrixFormat::petsc_binary);
  Matrix back;
  Viewer viewer;
  PetscViewerBinaryOpen(world, (folder / "K.bin").c_str(), FILE_MODE_READ, viewer.out());
  MatCreate(world, back.out());
  MatLoad(back, viewer);
  PetscInt first = 0, last = 0;
  MatGetOwnershipRange(back, &first, &last);
  for (PetscInt i = first; i < last; ++i)
    for (PetscInt j = 0; j < order_of_matrix; ++j) {
      PetscScalar value = 0;
      MatGetValue(back, i, j, &value);
      EXPECT_EQ(value, whole(order_of_matrix - 1 - i, order_of_matrix - 1 - j));
    }
}

}  // namespace
}  // namespace ritz::algebra
