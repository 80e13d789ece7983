// Element integrals allocate nothing.
#include <gtest/gtest.h>

#include <memory>

#include "fem/sample_cells.hpp"
#include "ritz/fem/face.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/fem/mass.hpp"
#include "ritz/fem/response.hpp"
#include "ritz/fem/stiffness.hpp"
#include "support/allocations.hpp"

namespace ritz::fem::testing {
namespace {

/// Every integral of a cell, as one number.
template <class E>
double everything(const Coordinates<E>& x) {
  const Material material{NeoHookean{1, .3}, 1};
  const auto points = integration_points<E>(x);
  return stiffness<E>(x, material.at_rest()).trace() + mass<E>(x, 1).trace() + volume<E>(x) + smallest_jacobian<E>(x) +
         smallest_integrated_jacobian<E>(x) + shortest_edge<E>(x) +
         energy_and_force<E>(points, .1 * x, material).energy + tangent<E>(points, .1 * x, material).trace() +
         turned_inside_out<E>(x, x);
}

template <class F>
double loads() {
  const auto x = random_matrix<3, F::vertices>(2);
  return pressure_vectors<F>(x).sum() + traction_weights<F>(x).sum();
}

TEST(NoMalloc, AllocationsAreCounted) {
  ASSERT_TRUE(test::counts_allocations());
  const auto before = test::allocations();
  const auto number = std::make_unique<double>(1);
  EXPECT_EQ(test::allocations(), before + 1);
  const Eigen::VectorXd vector = Eigen::VectorXd::Constant(1000, *number);
  EXPECT_EQ(test::allocations(), before + 2) << vector.sum();
}

TEST(NoMalloc, ElementsDoNotAllocate) {
  const auto four = curved_cell<Tet4>(1);
  const auto ten = curved_cell<Tet10>(1);
  const auto eight = curved_cell<Hex8>(1);
  const auto before = test::allocations();
  const double sum =
      everything<Tet4>(four) + everything<Tet10>(ten) + everything<Hex8>(eight) + smallest_dihedral<Tet4>(four);
  EXPECT_EQ(test::allocations(), before);
  EXPECT_TRUE(std::isfinite(sum));
}

TEST(NoMalloc, FacesDoNotAllocate) {
  const auto before = test::allocations();
  const double sum = loads<Tri3>() + loads<Tri6>() + loads<Quad4>();
  EXPECT_EQ(test::allocations(), before);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace ritz::fem::testing
