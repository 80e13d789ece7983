#include "ritz/runtime/model.hpp"

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

const Eigen::VectorXd& stiffness_of(const Model<double>& model) {
  return std::get<LinearForce<double>>(model.force).stiffness;
}

const Eigen::VectorXd& damping_of(const Model<double>& model) { return std::get<Vector<double>>(model.damping); }

TEST(Oscillators, RigidModesHaveNoStiffnessAndOnlyAlpha) {
  const std::array ratio = {.1};
  const auto o = make_model(modes(), {.alpha = .5, .beta = .01, .ratio = ratio});
  EXPECT_EQ(stiffness_of(o)[0], 0);
  EXPECT_EQ(damping_of(o)[0], .5);
  EXPECT_DOUBLE_EQ(damping_of(o)[1], .5 + .04 + 2 * .1 * 2);
}

TEST(Oscillators, RatiosCountFlexibleModesAndHoldTheLast) {
  const std::array ratio = {.01, .02};
  const auto o = make_model(modes(), {.ratio = ratio});
  EXPECT_EQ(damping_of(o)[0], 0);
  EXPECT_DOUBLE_EQ(damping_of(o)[1], 2 * .01 * 2);
  EXPECT_DOUBLE_EQ(damping_of(o)[2], 2 * .02 * 3);
  EXPECT_DOUBLE_EQ(damping_of(o)[3], 2 * .02 * 4);
}

TEST(Oscillators, RefuseANegativeEigenvalue) {
  auto m = modes();
  m.eigenvalues[2] = -1;
  EXPECT_THROW(make_model(m, {}), InputError);
}

TEST(Oscillators, EnergyIsKineticPlusElastic) {
  const auto o = make_model(modes(), {});
  auto room = make_evaluation(o.force);
  const Eigen::VectorXd z = Eigen::Vector4d(5, 1, 2, 0), velocity = Eigen::Vector4d(1, 0, 0, 2);
  EXPECT_DOUBLE_EQ(energy<double>(o, z, velocity, room), .5 * (1 + 4 + 4 + 36));
}

}  // namespace
}  // namespace ritz::runtime
