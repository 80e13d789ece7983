#include "ritz/runtime/statics.hpp"

#include <gtest/gtest.h>

#include "ritz/base/error.hpp"

namespace ritz::runtime {
namespace {

const Oscillators fixed{.stiffness = Eigen::Array2d(4, 9), .damping = Eigen::Array2d(1, 1)};
const Oscillators free_body{.stiffness = Eigen::Array2d(0, 9), .damping = Eigen::Array2d(0, 0)};

TEST(Statics, DividesByTheStiffness) {
  EXPECT_EQ(solve_static(fixed, Eigen::Vector2d(8, -9)), Eigen::VectorXd(Eigen::Vector2d(2, -1)));
}

TEST(Statics, ABodyThatIsPushedAwayHasNoStateOfRest) {
  try {
    solve_static(free_body, Eigen::Vector2d(1, 9));
    FAIL() << "a free body came to rest";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("the body is free"), std::string::npos) << e.what();
  }
}

TEST(Statics, ABalancedLoadOnAFreeBodyIsFine) {
  EXPECT_EQ(solve_static(free_body, Eigen::Vector2d(1e-12, 9)), Eigen::VectorXd(Eigen::Vector2d(0, 1)));
  EXPECT_EQ(solve_static(free_body, Eigen::Vector2d(0, 0)), Eigen::VectorXd(Eigen::Vector2d(0, 0)));
}

}  // namespace
}  // namespace ritz::runtime
