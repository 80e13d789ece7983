// Nearly incompressible, very unequal, very slender.
#include <gtest/gtest.h>

#include <numbers>

#include "ritz/base/error.hpp"
#include "support/graded_block.hpp"
#include "support/problem.hpp"
#include "support/statics.hpp"

namespace ritz::test {
namespace {

TEST(Extreme, QuadraticTetrahedraDoNotLockNearIncompressibility) {
  for (const auto& [poisson, expected] : {std::pair{.49, .31315}, {.499, .31357}, {.4999, .31363}}) {
    const Problem p = problem(graded_block(24, 4, 3), {fixed("xmin")}, {test::stvk(1e6, poisson, 1000)});
    EXPECT_NEAR(frequencies(modes(p, 1).modes)[0] / expected, 1, .02) << "nu = " << poisson;
  }
}

/// A bar of two halves along x, the second one `ratio` times as stiff.
Problem two_halves(const char* mesh, double poisson, double ratio) {
  mesh::Mesh bar = box(mesh);
  bar.regions.push_back({"stiff", std::nullopt});
  for (int c = 0; c < bar.cells.count(); ++c)
    bar.cells.regions[static_cast<std::size_t>(c)] = bar.corners(c).row(0).mean() > .5;
  return problem(std::move(bar), {fixed("xmin")},
                 {test::stvk(1e6, poisson, 1000), test::stvk(ratio * 1e6, poisson, 1000)});
}

TEST(Extreme, HalvesOfUnequalStiffnessStretchAsBarsInSeries) {
  // A stout bar: sideways stiff cells of the stiff half would lift the rounding of K, 1e6 times larger than in the soft
  // half, above the gate.
  for (const char* mesh : {"box:1,.5,.5/4,2,2/hex8", "box:1,.5,.5/4,2,2/tet4", "box:1,.5,.5/2,1,1/tet10"})
    for (const double ratio : {1e6, 1e-6}) {
      const Problem p = two_halves(mesh, 0, ratio);
      const auto force = end_traction(p, "xmax", Eigen::Vector3d::UnitX());
      const double area = .5 * .5, expected = .5 / (1e6 * area) + .5 / (ratio * 1e6 * area);
      EXPECT_NEAR(work(p, force, solve(p, force)) / expected, 1, 1e-8) << mesh << " ratio " << ratio;
    }
}

TEST(Extreme, ModesOfHalvesOfUnequalStiffnessAreCounted) {
  for (const double ratio : {1e6, 1e-6}) {
    modes(two_halves("box:1,.1,.06/8,2,1/hex8", .3, ratio), 12);
    modes(two_halves("box:1,.1,.06/4,1,1/tet10", .3, ratio), 12);
  }
}

/// f₁ of a cantilever of unit length and the given square section, Hz.
double euler_bernoulli(double side) {
  return 1.875104 * 1.875104 * std::sqrt(soft.at_rest().young() * side * side / 12 / soft.density) /
         (2 * std::numbers::pi);
}

TEST(Extreme, SlendernessOfAThousand) {
  const Problem p = problem(box("box:1,.001,.001/30,1,1/tet10"), {fixed("xmin")});
  const auto result = modes(p, 4);
  EXPECT_NEAR(frequencies(result.modes)[0] / euler_bernoulli(.001), 1, .01);
}

TEST(Extreme, SlendernessOfAThousandByMultigridIsRightOrRefused) {
  const Problem p = problem(box("box:1,.001,.001/30,1,1/tet10"), {fixed("xmin")});
  stages::ModesOptions iterative;
  iterative.count = 2;
  iterative.strategy = stages::Strategy::iterative;
  try {
    EXPECT_NEAR(frequencies(modes(p, iterative).modes)[0] / euler_bernoulli(.001), 1, .01);
  } catch (const NumericalError&) {
    SUCCEED();
  }
}

}  // namespace
}  // namespace ritz::test
