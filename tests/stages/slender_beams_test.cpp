// Slender beams against Euler-Bernoulli: the first bending modes in either direction.
#include <gtest/gtest.h>

#include <numbers>

#include "support/problem.hpp"

namespace ritz::test {
namespace {

constexpr double length = 1;  // m
constexpr double ratio = 2;   // of the two directions: width over height

/// (βL)² √(EI/ρA) / (2π L²), Hz, of a rectangle bending over its side `depth`.
double euler_bernoulli(double beta_L, double depth) {
  return beta_L * beta_L * std::sqrt(soft.at_rest().young() * depth * depth / 12 / soft.density) /
         (2 * std::numbers::pi * length * length);
}

/// Every βL appears once in each direction, in this order, within `gate`.
void expect_bending(const Eigen::VectorXd& found, double height, const std::vector<double>& beta_L, double gate) {
  std::vector<double> expected;
  for (const double b : beta_L)
    for (const double depth : {height, ratio * height}) expected.push_back(euler_bernoulli(b, depth));
  std::sort(expected.begin(), expected.end());
  // Those in y beyond the highest in z are beyond what is asked.
  expected.resize(
      static_cast<std::size_t>(std::find(expected.begin(), expected.end(), euler_bernoulli(beta_L.back(), height)) -
                               expected.begin()) +
      1);
  ASSERT_GE(found.size(), static_cast<Eigen::Index>(expected.size()));
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(found[static_cast<Eigen::Index>(i)] / expected[i], 1, gate) << "mode " << i + 1;
}

const char* const slender = "box:1,.02,.01/48,1,1/tet10";

TEST(SlenderBeam, CantileverHasEulerBernoullisFrequencies) {
  const auto result = modes(problem(box(slender), {fixed("xmin")}), 7);
  expect_bending(frequencies(result.modes), .01, {1.875104, 4.694091, 7.854757, 10.995541}, .005);
}

TEST(SlenderBeam, FreeBeamHasEulerBernoullisFrequencies) {
  const auto result = modes(problem(box(slender), {}), 7);
  EXPECT_EQ(rigid_count(result.modes), 6);
  expect_bending(frequencies(result.modes), .01, {4.730041, 7.853205, 10.995608, 14.137165}, .005);
}

TEST(SlenderBeam, AThousandTimesAsLongAsThickAndFree) {
  const auto result = modes(problem(box("box:1,.002,.001/60,2,2/tet10"), {}), 4);
  EXPECT_EQ(rigid_count(result.modes), 6);
  EXPECT_LE(result.modes.energies.head(6).maxCoeff(), 1e-6 * result.modes.eigenvalues[6]);
  expect_bending(frequencies(result.modes), .001, {4.730041, 7.853205}, .01);
}

}  // namespace
}  // namespace ritz::test
