// Element integrals allocate nothing.
#include <gtest/gtest.h>

#include <memory>

#include "fem/sample_cells.hpp"
#include "ritz/fem/cell_matrices.hpp"
#include "ritz/fem/face.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/fem/response.hpp"
#include "support/allocations.hpp"

namespace ritz::fem::testing {
namespace {

/// Every integral of a cell, as one number.
double everything(CellType type, const CellVectors& x) {
  const Material material{NeoHookean{1, .3}, 1};
  const IntegrationPoints points(type, x);
  const CellVectors u = .1 * x;
  return stiffness(type, x, material.at_rest()).trace() + mass(type, x, 1).trace() + volume(type, x) +
         smallest_jacobian(type, x) + smallest_integrated_jacobian(type, x) + shortest_edge(type, x) +
         energy_and_force(points, u, material).energy + tangent(points, u, material).trace() +
         turned_inside_out(type, x, x) + straight(type, x);
}

double loads(FaceType type, const FaceVectors& x) {
  return pressure_vectors(type, x).sum() + traction_weights(type, x).sum();
}

struct NoMalloc : ::testing::Test {
  void SetUp() override {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "this sanitizer allocates in its own way";
#endif
  }
};

TEST_F(NoMalloc, AllocationsAreCounted) {
  ASSERT_TRUE(test::counts_allocations());
  const auto before = test::allocations();
  const auto number = std::make_unique<double>(1);
  EXPECT_EQ(test::allocations(), before + 1);
  const Eigen::VectorXd vector = Eigen::VectorXd::Constant(1000, *number);
  EXPECT_EQ(test::allocations(), before + 2) << vector.sum();
}

TEST_F(NoMalloc, ElementsDoNotAllocate) {
  for (const auto type : cell_types) {
    const auto x = curved_cell(type, 1);
    everything(type, x);  // tables are made when they are first asked for
    const auto before = test::allocations();
    const double sum = everything(type, x);
    EXPECT_EQ(test::allocations(), before) << shape(type).name;
    EXPECT_TRUE(std::isfinite(sum));
  }
}

TEST_F(NoMalloc, FacesDoNotAllocate) {
  for (const auto type : face_types) {
    const FaceVectors x = random_numbers(3, shape(type).vertices, 2);
    loads(type, x);
    const auto before = test::allocations();
    const double sum = loads(type, x);
    EXPECT_EQ(test::allocations(), before) << shape(type).name;
    EXPECT_TRUE(std::isfinite(sum));
  }
}

}  // namespace
}  // namespace ritz::fem::testing
