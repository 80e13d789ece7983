// Steps that solve a linearised equation once: what they cost, when they go on, and what they say of their error.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/nonlinear_support.hpp"

namespace ritz::runtime {
namespace {

using Eigen::VectorXd;

constexpr Eigen::Index coordinates = 4;

VectorXd deflected(double size) { return size * VectorXd::LinSpaced(coordinates, 1, -0.6); }

struct Path {
  Eigen::MatrixXd z;  ///< of all states, one a column
  int longer = 0;     ///< steps that took more than one evaluation
  double error = 0;   ///< the sum of the estimates
};

/// Three seconds of a motion that starts from a deflection.
Path path(const Integrator& method, int steps, const Damping& damping = {}) {
  auto motion = test::start(test::random_polynomial(coordinates, 6), method, 3.0 / steps, deflected(0.2), 0.1, damping);
  Path path{.z = Eigen::MatrixXd(coordinates, steps + 1)};
  path.z.col(0) = motion.state.z();
  for (int n = 1; n <= steps; ++n) {
    const auto outcome = motion.step();
    EXPECT_EQ(outcome.status, Status::done);
    path.longer += outcome.evaluations > 1;
    path.error += outcome.error;
    path.z.col(n) = motion.state.z();
  }
  return path;
}

/// The largest distance between two paths, the finer of which has so many steps for each of the other.
double apart(const Path& coarse, const Path& fine, Eigen::Index each) {
  double largest = 0;
  for (Eigen::Index n = 0; n < coarse.z.cols(); ++n)
    largest = std::max(largest, (coarse.z.col(n) - fine.z.col(n * each)).norm());
  return largest;
}

TEST(LinearlyImplicit, OneEvaluationGivesTheConvergedPathWhereTheStepResolvesTheMotion) {
  for (const int steps : {300, 600}) {
    const auto once = path(linearly_implicit(), steps), converged = path(generalized_alpha(), steps);
    EXPECT_EQ(once.longer, 0) << steps;
    EXPECT_EQ(converged.longer, steps);
    const double error = apart(once, path(avf(), 16 * steps), 16), between = apart(once, converged, 1);
    EXPECT_LE(between, 1e-3 * error) << steps;
    EXPECT_GT(between, 0) << steps;
  }
}

TEST(LinearlyImplicit, TheErrorThatItSaysIsNearTheErrorThatItHas) {
  for (const auto& damping : {Damping{}, Damping{.alpha = 0.2, .beta = 0.01, .ratio = {}}})
    for (const int steps : {150, 300, 600}) {
      const auto coarse = path(linearly_implicit(), steps, damping);
      const double error = apart(coarse, path(avf(), 16 * steps, damping), 16);
      EXPECT_GE(coarse.error, 0.5 * error) << steps;
      EXPECT_LE(coarse.error, 3 * error) << steps;
    }
}

TEST(LinearlyImplicit, IteratesAtASuddenLoadAsTheConvergedMethodDoes) {
  const auto polynomial = test::random_polynomial(coordinates, 20);
  auto motion = test::start(polynomial, linearly_implicit(), 0.3, deflected(1));
  auto converged = test::start(polynomial, generalized_alpha(), 0.3, deflected(1));
  const VectorXd none = VectorXd::Zero(coordinates), blow = VectorXd::Constant(coordinates, 400);
  const auto outcome = step<double>(motion.model, motion.state, {none, blow}, 0.3, motion.workspace);
  const auto same = step<double>(converged.model, converged.state, {none, blow}, 0.3, converged.workspace);
  EXPECT_EQ(outcome.evaluations, same.evaluations + 1);
  EXPECT_EQ(outcome.iterations, same.iterations);
  EXPECT_EQ(motion.state.history, converged.state.history);
}

TEST(LinearlyImplicit, StaysWhereTheConvergedMethodStays) {
  struct Case {
    double size, dt;  // Δt ω_max up to 260
  };
  for (const auto& [size, dt] : {Case{.3, .003}, {.3, .01}, {.1, .01}, {.1, .03}, {.1, 1}}) {
    const auto polynomial = test::random_polynomial(coordinates, 260);
    auto motion = test::start(polynomial, linearly_implicit(), dt, deflected(size));
    auto converged = test::start(polynomial, generalized_alpha(), dt, deflected(size));
    double largest = 0, bound = motion.energy();
    for (int n = 0; n < 1000; ++n) {
      ASSERT_EQ(motion.step().status, Status::done) << size << ' ' << dt << ' ' << n;
      ASSERT_EQ(converged.step().status, Status::done) << size << ' ' << dt << ' ' << n;
      largest = std::max(largest, motion.energy());
      bound = std::max(bound, converged.energy());
    }
    EXPECT_LE(largest, 1.05 * bound) << size << ' ' << dt;
  }
}

TEST(LinearlyImplicit, OthersSayNothingOfTheirError) {
  for (const auto& method : test::all_methods()) {
    auto motion = test::start(test::random_polynomial(coordinates), method, 0.01, deflected(1));
    EXPECT_EQ(std::isnan(motion.step().error), method.name != "linearly-implicit") << method.name;
  }
}

}  // namespace
}  // namespace ritz::runtime
