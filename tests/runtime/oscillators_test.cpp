#include "ritz/runtime/oscillators.hpp"

#include <gtest/gtest.h>

#include <array>

#include "ritz/base/error.hpp"

namespace ritz::runtime {
namespace {

model::Modes modes() {
  model::Modes m;
  m.eigenvalues = Eigen::Vector4d(1e-9, 4, 9, 16);  // a rigid mode's eigenvalue as noise
  m.kinds = {model::ModeKind::rigid, model::ModeKind::flexible, model::ModeKind::flexible, model::ModeKind::flexible};
  return m;
}

TEST(Oscillators, RigidModesHaveNoStiffnessAndOnlyAlpha) {
  const std::array ratio = {.1};
  const Oscillators o = make_oscillators(modes(), {.alpha = .5, .beta = .01, .ratio = ratio});
  EXPECT_EQ(o.stiffness[0], 0);
  EXPECT_EQ(o.damping[0], .5);
  EXPECT_DOUBLE_EQ(o.damping[1], .5 + .04 + 2 * .1 * 2);
}

TEST(Oscillators, RatiosCountFlexibleModesAndHoldTheLast) {
  const std::array ratio = {.01, .02};
  const Oscillators o = make_oscillators(modes(), {.ratio = ratio});
  EXPECT_EQ(o.damping[0], 0);
  EXPECT_DOUBLE_EQ(o.damping[1], 2 * .01 * 2);
  EXPECT_DOUBLE_EQ(o.damping[2], 2 * .02 * 3);
  EXPECT_DOUBLE_EQ(o.damping[3], 2 * .02 * 4);
}

TEST(Oscillators, RefuseANegativeEigenvalue) {
  auto m = modes();
  m.eigenvalues[2] = -1;
  EXPECT_THROW(make_oscillators(m, {}), InputError);
}

TEST(Oscillators, EnergyIsKineticPlusElastic) {
  const Oscillators o = make_oscillators(modes(), {});
  EXPECT_DOUBLE_EQ(energy(o, Eigen::Vector4d(5, 1, 2, 0), Eigen::Vector4d(1, 0, 0, 2)), .5 * (1 + 4 + 4 + 36));
}

}  // namespace
}  // namespace ritz::runtime
