#include "ritz/runtime/reconstruction.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace ritz::runtime {
namespace {

const model::Basis basis{
    (model::RowMatrix(9, 2) << 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18).finished()};
const Eigen::Vector2d z(2, -1);

TEST(Reconstruction, OfAllVertices) {
  model::Points u(3, 3);
  reconstruct(basis, z, u);
  EXPECT_EQ(u, (model::Points(3, 3) << 0, 2, 4, 6, 8, 10, 12, 14, 16).finished());
}

TEST(Reconstruction, OfAnyNumberOfVerticesAndColumns) {
  for (const Eigen::Index n : {1, 2, 3, 4, 5, 7})
    for (const Eigen::Index r : {1, 2, 3, 4, 5, 8, 11, 30}) {
      const model::Basis any{model::RowMatrix::Random(3 * n, r)};
      const Eigen::VectorXd coordinates = Eigen::VectorXd::LinSpaced(r, -1, 2);
      model::Points u(n, 3);
      reconstruct(any, coordinates, u);
      for (Eigen::Index i = 0; i < 3 * n; ++i) {
        double sum = 0;
        for (Eigen::Index j = 0; j < r; ++j) sum += any.U(i, j) * coordinates[j];
        EXPECT_NEAR(u.data()[i], sum, 1e-15 * static_cast<double>(r + 10)) << n << ' ' << r << ' ' << i;
      }
    }
}

template <class Scalar>
void expect_copies_to_agree() {
  for (const Eigen::Index n : {1, 2, 5, 10, 11, 64, 67})
    for (const Eigen::Index r : {1, 3, 8, 30}) {
      const model::Basis any{model::RowMatrix::Random(3 * n, r)};
      const Eigen::VectorXd coordinates = Eigen::VectorXd::LinSpaced(r, -1, 2);
      const Eigen::VectorXd u = any.U * coordinates;
      const Eigen::VectorXd terms = any.U.cwiseAbs() * coordinates.cwiseAbs();
      const double rounding = (double(r) / 2 + 2) * double(std::numeric_limits<Scalar>::epsilon());
      Displacements<Scalar> all(n, 3);
      reconstruct<Scalar>(make_reconstruction<Scalar>(any), coordinates, all);
      for (Eigen::Index i = 0; i < 3 * n; ++i)
        EXPECT_NEAR(double(all.data()[i]), u[i], rounding * terms[i]) << n << ' ' << r << ' ' << i;

      const std::vector<std::int64_t> asked = {n - 1, n / 2, 0, n - 1};
      Displacements<Scalar> some(4, 3);
      reconstruct<Scalar>(make_reconstruction<Scalar>(any, asked), coordinates, some);
      for (std::size_t k = 0; k < asked.size(); ++k) EXPECT_EQ(some.row(Eigen::Index(k)), all.row(asked[k]));
    }
}

TEST(Reconstruction, FromACopyOfAllOrOfSomeVertices) {
  expect_copies_to_agree<float>();
  expect_copies_to_agree<double>();
}

TEST(Reconstruction, OfOneVertexAndOfAMean) {
  EXPECT_EQ(Eigen::Vector3d(mean_rows(basis, std::array<std::int64_t, 1>{1}) * z), Eigen::Vector3d(6, 8, 10));
  EXPECT_EQ(Eigen::Vector3d(mean_rows(basis, std::array<std::int64_t, 2>{0, 2}) * z), Eigen::Vector3d(6, 8, 10));
}

}  // namespace
}  // namespace ritz::runtime
