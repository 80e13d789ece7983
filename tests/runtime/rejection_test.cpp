// Steps that fail: rejected, halved, counted, and never accepted.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "ritz/base/error.hpp"
#include "runtime/nonlinear_support.hpp"

namespace ritz::runtime {
namespace {

using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Rejection, AnAttemptThatDoesNotConvergeIsHalved) {
  const NewtonOptions<double> hasty{.iterations = 3};
  for (const auto& method : test::implicit_methods()) {
    auto motion = test::start(test::random_polynomial(4, 20), method, 1.0, VectorXd::Ones(4), 40, {}, hasty);
    const auto outcome = motion.step();
    EXPECT_EQ(outcome.status, Status::done) << method.name;
    EXPECT_GT(outcome.rejected, 0) << method.name;
    EXPECT_GT(outcome.iterations, 3 * outcome.rejected) << method.name;
    EXPECT_LT(motion.state.last_dt, 1.0) << method.name;
  }
}

TEST(Rejection, HalvesMakeTheStepsOfThatLength) {
  const NewtonOptions<double> hasty{.iterations = 3};
  const auto polynomial = test::random_polynomial(4, 20);
  auto motion = test::start(polynomial, avf(), 1.0, VectorXd::Ones(4), 0, {}, hasty);
  const double begin = motion.energy();
  const auto outcome = motion.step();
  ASSERT_EQ(outcome.status, Status::done);
  ASSERT_GT(outcome.rejected, 0);
  EXPECT_NEAR(motion.energy(), begin, 1e-10 * begin);
}

TEST(Rejection, LoadAndDampingWorkAlongTheHalves) {
  const NewtonOptions<double> hasty{.iterations = 3};
  const auto polynomial = test::random_polynomial(4, 20);
  for (const Damping& damping : {Damping{}, Damping{.alpha = .3, .beta = .02, .ratio = {}}}) {
    auto motion = test::start(polynomial, avf(), 1.0, VectorXd::Ones(4), 0, damping, hasty);
    const double begin = motion.energy();
    const VectorXd first = VectorXd::Zero(4), last = VectorXd::Constant(4, 40);
    const auto outcome = step<double>(motion.model, motion.state, {first, last}, 1.0, motion.workspace);
    ASSERT_EQ(outcome.status, Status::done);
    ASSERT_GT(outcome.rejected, 0);
    EXPECT_EQ(outcome.dissipated > 0, damping.alpha > 0);
    EXPECT_NEAR(motion.energy() - begin, outcome.work - outcome.dissipated, 1e-9 * begin);
  }
}

TEST(Rejection, LeavesTheStateWhenHalvingDoesNotHelp) {
  const NewtonOptions<double> never{.iterations = 0, .halvings = 3};
  for (const auto& method : test::implicit_methods()) {
    auto motion = test::start(test::random_polynomial(4), method, 0.1, VectorXd::Ones(4), 1, {}, never);
    const auto before = motion.state;
    const auto outcome = motion.step();
    EXPECT_EQ(outcome.status, Status::not_converged) << method.name;
    EXPECT_EQ(outcome.rejected, 4) << method.name;
    EXPECT_EQ(motion.state.history, before.history);
    EXPECT_EQ(motion.state.last_dt, before.last_dt);
  }
}

TEST(Rejection, OfWhatIsNotFinite) {
  for (const auto& method : test::all_methods()) {
    auto motion = test::start(test::random_polynomial(4), method, 0.1, VectorXd::Ones(4), 1);
    motion.step();
    const auto before = motion.state;
    for (const double bad : {infinite, -infinite, std::numeric_limits<double>::quiet_NaN()}) {
      const VectorXd load = VectorXd::Constant(4, bad);
      const auto outcome = step<double>(motion.model, motion.state, {load, load}, 0.1, motion.workspace);
      EXPECT_NE(outcome.status, Status::done) << method.name << bad;
      EXPECT_GT(outcome.rejected, 0);
      EXPECT_EQ(motion.state.history, before.history) << method.name;
    }
    EXPECT_EQ(motion.step().status, Status::done) << method.name;
  }
}

TEST(Rejection, OfAnExplicitStepThatIsUnstableAtRest) {
  const auto method = central_difference();
  for (const double stiffness : {25., 3.999961, 2.6243e12, 7e-9}) {
    const auto polynomial = test::duffing(stiffness, 1);
    const double longest = 2 / std::sqrt(stiffness);
    try {
      test::start(polynomial, method, 1.25 * longest, VectorXd::Ones(1));
      FAIL() << "an unstable step was taken";
    } catch (const InputError& error) {
      const std::string text = error.what();
      const double advised = std::stod(text.substr(text.find("at most ") + 8));
      EXPECT_NEAR(advised, longest, 2e-5 * longest) << text;
      EXPECT_NO_THROW(test::start(polynomial, method, advised, VectorXd::Ones(1))) << text;
    }
  }
  const auto polynomial = test::duffing(25, 1);
  auto motion = test::start(polynomial, method, 0.4, VectorXd::Constant(1, 1e-3));
  EXPECT_EQ(motion.step().status, Status::done);
  motion.dt = 0.41;
  EXPECT_THROW(motion.step(), InputError);
  EXPECT_THROW(test::start(polynomial, avf(), 0.0, VectorXd::Ones(1)), InputError);
}

}  // namespace
}  // namespace ritz::runtime
