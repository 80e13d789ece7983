#include "ritz/runtime/statics.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace ritz::runtime {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

struct Rest {
  StaticOutcome outcome;
  VectorXd z;
};

/// Two oscillators of these stiffnesses at rest under a load.
Rest rest(const Vector2d& stiffness, const Vector2d& load) {
  const Model<double> model{.force = LinearForce<double>{stiffness}, .damping = VectorXd(Vector2d::Zero())};
  auto workspace = make_static_workspace(model);
  const VectorXd none = Vector2d::Zero(), end = load;
  Rest rest{.outcome = {}, .z = none};
  rest.outcome = solve_static<double>(model, {none, end}, rest.z, workspace);
  return rest;
}

TEST(Statics, DividesByTheStiffness) {
  const auto found = rest({4, 9}, {8, -9});
  EXPECT_FALSE(found.outcome.failure);
  EXPECT_EQ(found.z, VectorXd(Vector2d(2, -1)));
}

TEST(Statics, ABodyThatIsPushedAwayHasNoStateOfRest) {
  const auto found = rest({9, 0}, {9, 1});
  EXPECT_EQ(found.outcome.failure, NoRest::free_body);
  EXPECT_EQ(found.outcome.pushed, 1);
  EXPECT_EQ(found.z, VectorXd(Vector2d(0, 0)));
}

TEST(Statics, ABalancedLoadOnAFreeBodyIsFine) {
  EXPECT_EQ(rest({0, 9}, {1e-12, 9}).z, VectorXd(Vector2d(0, 1)));
  EXPECT_EQ(rest({0, 9}, {0, 0}).z, VectorXd(Vector2d(0, 0)));
  EXPECT_FALSE(rest({0, 9}, {1e-12, 9}).outcome.failure);
}

TEST(Statics, NameALoadThatIsNotFinite) {
  EXPECT_EQ(rest({4, 9}, {std::numeric_limits<double>::infinity(), 0}).outcome.failure, NoRest::not_finite);
}

}  // namespace
}  // namespace ritz::runtime
