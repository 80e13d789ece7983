// The remainder of Eq. 17's Taylor series: what it tells of derivatives that are right, missing or wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "ritz/base/error.hpp"
#include "ritz/stages/witness.hpp"
#include "support/reduction.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;

struct Expansion {
  const char* mesh;
  bool free, two;
};

class Taylor : public testing::TestWithParam<Expansion> {
 protected:
  Reduced r = reduced(box_of(std::string("box:1,.4,.3/") + GetParam().mesh, GetParam().free, GetParam().two), 4);
  const Eigen::VectorXd p = Eigen::VectorXd::LinSpaced(r.flexible.cols(), 1, -.5);

  /// ½ Σ p_i p_j Φ_ij over all i and j.
  Tall second_order() const {
    const auto all = all_derivatives(r);
    Tall sum = Tall::Zero(r.flexible.rows(), 1);
    for (std::size_t n = 0; n < all.pairs.size(); ++n) {
      const auto [i, j] = all.pairs[n];
      const double twice = i == j ? 1 : 2;  // Φ_ij = Φ_ji
      sum += .5 * twice * p[i] * p[j] * all.columns.col(static_cast<Eigen::Index>(n));
    }
    return sum;
  }
  double slope(const Tall& curve) const { return stages::taylor_slope(r.source(), r.flexible * p, curve); }
};

TEST_P(Taylor, WithDerivativesTheSlopeIsThree) {
  const double found = slope(second_order());
  EXPECT_GE(found, 2.9);
  EXPECT_LE(found, 3.1);
  EXPECT_NO_THROW(stages::require_third_order(found));
}

// Without derivatives; with the wrong sign in Eq. 15; without the ½ of Eq. 17.
TEST_P(Taylor, OtherwiseItIsTwo) {
  const Tall curve = second_order();
  for (const double factor : {0., -1., 2.}) {
    const double found = slope(factor * curve);
    EXPECT_NEAR(found, 2, .1) << factor;
    EXPECT_THROW(stages::require_third_order(found), NumericalError) << factor;
  }
}

TEST_P(Taylor, TheWitnessPasses) { EXPECT_NEAR(stages::taylor_witness(r.source()), 3, .1); }

// Modes are the same for all laws of the same constants at rest; derivatives are each law's own.
TEST_P(Taylor, AnotherLawHasOtherDerivatives) {
  const Tall of_stvk = second_order();
  r.p.materials = neo_hookean(r.p.materials);
  EXPECT_NEAR(slope(second_order()), 3, .1);
  EXPECT_NEAR(slope(of_stvk), 2, .1);
}

// Derivatives of another material are derivatives that are wrong, of forces and a K that are right.
TEST_P(Taylor, DerivativesOfAnotherMaterialAreNoticed) {
  const auto right = r.p.materials;
  for (auto& material : r.p.materials)
    material.law = fem::StVK{material.at_rest().young(), .9 * material.at_rest().poisson()};
  const Tall curve = second_order();
  r.p.materials = right;
  EXPECT_THROW(stages::require_third_order(slope(curve)), NumericalError);
}

// Forces and derivatives of another material than K and the modes.
TEST_P(Taylor, TheWitnessNoticesAnotherMaterial) {
  for (auto& material : r.p.materials)
    material.law = fem::StVK{material.at_rest().young(), .9 * material.at_rest().poisson()};
  EXPECT_THAT([&] { stages::taylor_witness(r.source()); },
              testing::ThrowsMessage<NumericalError>(testing::HasSubstr("fail their own test")));
}

INSTANTIATE_TEST_SUITE_P(, Taylor,
                         testing::Values(Expansion{"4,2,2/tet4", false, true}, Expansion{"4,2,2/tet4", true, false},
                                         Expansion{"3,1,1/tet10", false, true}, Expansion{"3,1,1/tet10", true, false},
                                         Expansion{"4,2,2/hex8", false, false}, Expansion{"4,2,2/hex8", true, true}),
                         [](const auto& info) {
                           const std::string text = info.param.mesh;
                           return text.substr(text.rfind('/') + 1) + (info.param.free ? "_free" : "_clamped");
                         });

// Rounding hides most of what a very slender beam's derivatives leave, but not all.
TEST(TaylorGate, HoldsForVerySlenderBeams) {
  for (const auto* box : {"box:1,.001,.001/30,1,1/tet10", "box:1,.0005,.0005/20,1,1/tet10"}) {
    const Reduced r = reduced(box_of(box, false), 3);
    EXPECT_NEAR(stages::taylor_witness(r.source()), 3, .1) << box;
  }
}

TEST(TaylorGate, TakesNothingButThree) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const double slope : {2.9, 3., 3.1}) EXPECT_NO_THROW(stages::require_third_order(slope));
  for (const double slope : {0., 2., 2.89, 3.11, -3., infinite})
    EXPECT_THROW(stages::require_third_order(slope), NumericalError) << slope;
  try {
    stages::require_third_order(std::numeric_limits<double>::quiet_NaN());
    ADD_FAILURE() << "a slope that is not a number passed";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("rounding"));
  }
}

}  // namespace
}  // namespace ritz::test
