#include "ritz/runtime/reconstruction.hpp"

#include <gtest/gtest.h>

#include <array>

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

TEST(Reconstruction, OfOneVertexAndOfAMean) {
  EXPECT_EQ(Eigen::Vector3d(mean_rows(basis, std::array<std::int64_t, 1>{1}) * z), Eigen::Vector3d(6, 8, 10));
  EXPECT_EQ(Eigen::Vector3d(mean_rows(basis, std::array<std::int64_t, 2>{0, 2}) * z), Eigen::Vector3d(6, 8, 10));
}

}  // namespace
}  // namespace ritz::runtime
