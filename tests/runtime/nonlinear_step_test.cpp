#include "ritz/runtime/nonlinear_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ritz/base/error.hpp"
#include "ritz/runtime/integrators.hpp"
#include "runtime/nonlinear_support.hpp"

namespace ritz::runtime {
namespace {

using Eigen::VectorXd;

VectorXd some(Eigen::Index r, double size = 1) { return size * VectorXd::LinSpaced(r, 1, -0.6); }

/// z(1) of a damped body that starts from a large deflection under a force.
VectorXd after_one_second(const Method<double>& method, int steps) {
  auto motion = test::start(test::random_polynomial(4, 6), method, 1.0 / steps, some(4, 0.8), 0.5,
                            {.alpha = 0.2, .beta = 0.01, .ratio = {}});
  for (int n = 0; n < steps; ++n) EXPECT_EQ(motion.step().status, Status::done);
  return motion.state.z();
}

TEST(NonlinearStep, HasItsOrder) {
  const VectorXd exact = after_one_second(nonlinear_avf<double>(), 40000);
  for (const auto& method : test::all_methods<double>()) {
    const double coarse = (after_one_second(method, 400) - exact).norm();
    const double fine = (after_one_second(method, 800) - exact).norm();
    EXPECT_NEAR(std::log2(coarse / fine), method.name == "implicit-euler" ? 1 : 2, 0.1) << method.name;
  }
}

TEST(NonlinearStep, AvfKeepsTheEnergyOfStiffLargeMotions) {
  const Eigen::Index r = 4;
  const double stiffest = 260, dt = 0.1;  // Δt ω_max = 26
  auto motion = test::start(test::random_polynomial(r, stiffest), nonlinear_avf<double>(), dt, some(r));
  const double begin = motion.energy();
  double worst = 0;
  int rejected = 0;
  for (int n = 0; n < 50000; ++n) {
    const auto outcome = motion.step();
    ASSERT_EQ(outcome.status, Status::done) << n;
    rejected += outcome.rejected;
    if (n % 50 == 0 || n == 49999) worst = std::max(worst, std::abs(motion.energy() - begin) / begin);
  }
  EXPECT_LE(worst, 1e-9);
  RecordProperty("rejected", rejected);
}

TEST(NonlinearStep, AvfKeepsTheEnergyAtAbsurdSteps) {
  auto motion = test::start(test::random_polynomial(4, 260), nonlinear_avf<double>(), 1e3 / 260, some(4));
  const double begin = motion.energy();
  for (int n = 0; n < 2000; ++n) ASSERT_EQ(motion.step().status, Status::done) << n;
  EXPECT_NEAR(motion.energy(), begin, 1e-8 * begin);
}

TEST(NonlinearStep, AvfChangesTheEnergyByTheWorkOfTheLoad) {
  auto motion = test::start(test::random_polynomial(5), nonlinear_avf<double>(), 0.3, some(5), 2.0);
  double work = motion.energy();
  for (int n = 0; n < 200; ++n) {
    const VectorXd before = motion.state.z();
    motion.step();
    work += motion.force.dot(motion.state.z() - before);
    ASSERT_NEAR(motion.energy(), work, 1e-9 * std::abs(work));
  }
}

TEST(NonlinearStep, DissipativeMethodsDoNotGainEnergy) {
  for (const auto& method : {nonlinear_implicit_euler<double>(), nonlinear_bdf2<double>()})
    for (const double dt : {0.01, 0.1, 1.0, 100.0}) {
      auto motion = test::start(test::random_polynomial(4, 260), method, dt, some(4));
      const double begin = motion.energy();
      for (int n = 0; n < 500; ++n) {
        ASSERT_EQ(motion.step().status, Status::done) << method.name << dt;
        ASSERT_LE(motion.energy(), begin * (1 + 1e-9)) << method.name << ' ' << dt << ' ' << n;
      }
    }
}

TEST(NonlinearStep, ImplicitEulerNeverGainsEnergyOnALinearModel) {
  const auto polynomial = test::linear_part(test::random_polynomial(4, 260));
  auto motion = test::start(polynomial, nonlinear_implicit_euler<double>(), 0.01, some(4));
  for (double last = motion.energy(); motion.energy() > 1e-12; last = motion.energy()) {
    motion.step();
    ASSERT_LE(motion.energy(), last * (1 + 1e-12));
  }
}

TEST(NonlinearStep, OfALinearPolynomialIsTheLinearStep) {
  const auto polynomial = test::linear_part(test::duffing(9, 1));
  const Damping damping{.alpha = 0.3, .beta = 0.02, .ratio = {}};
  const Oscillators linear{.stiffness = Eigen::ArrayXd::Constant(1, 9),
                           .damping = Eigen::ArrayXd::Constant(1, 0.3 + 0.02 * 9)};
  const std::vector<Integrator> integrators = {implicit_euler(), newmark(), generalized_alpha(),
                                               bdf2(),           avf(),     central_difference()};
  const auto methods = test::all_methods<double>();
  const VectorXd z = VectorXd::Ones(1), rest = VectorXd::Zero(1);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    ASSERT_EQ(methods[m].name, integrators[m].name);
    auto motion = test::start(polynomial, methods[m], 0.05, z, 1.0, damping);
    auto state = make_state(linear, integrators[m], z, rest, motion.force);
    auto workspace = make_workspace(linear, integrators[m], 0.05);
    for (int n = 0; n < 100; ++n) {
      const VectorXd begin = VectorXd::Constant(1, 1 + 0.1 * n), end = VectorXd::Constant(1, 1.1 + 0.1 * n);
      step(motion.model, motion.state, {begin, end}, 0.05, motion.workspace);
      step(linear, state, {begin, end}, 0.05, workspace);
    }
    EXPECT_LE((motion.state.history - state.history).norm(), 1e-11 * state.history.norm()) << methods[m].name;
  }
}

TEST(NonlinearStep, GoesOnFromAStoredStateBitByBit) {
  for (const auto& method : test::all_methods<double>()) {
    auto motion = test::start(test::random_polynomial(6), method, 0.05, some(6), 1.0);
    for (int n = 0; n < 20; ++n) motion.step();
    auto later = test::start(test::random_polynomial(6), method, 0.05, some(6, 0.1), 1.0);
    later.state = motion.state;
    for (int n = 0; n < 20; ++n) motion.step(), later.step();
    EXPECT_EQ(motion.state.history, later.state.history) << method.name;
  }
}

TEST(NonlinearStep, LinearisationIsTheDerivativeOfTheResidual) {
  for (const auto& method : test::implicit_methods<double>()) {
    auto motion =
        test::start(test::random_polynomial(4), method, 0.2, some(4), 1.0, {.alpha = 1, .beta = 0.1, .ratio = {}});
    motion.step();
    const VectorXd delta = some(4, 0.3);
    auto& w = motion.workspace;
    const auto residual_at = [&](const VectorXd& d) {
      linearise(motion.model, motion.state, d, w);
      return w.residual;
    };
    method.equation(motion.model, motion.state, {motion.force, motion.force}, 0.2, w.equation);
    residual_at(delta);
    const Eigen::MatrixXd jacobian = w.jacobian;
    for (Eigen::Index i = 0; i < 4; ++i) {
      const VectorXd side = 1e-5 * VectorXd::Unit(4, i);
      const VectorXd slope = (residual_at(delta + side) - residual_at(delta - side)) / 2e-5;
      EXPECT_LE((slope - jacobian.col(i)).norm(), 1e-7 * jacobian.norm()) << method.name;
    }
  }
}

template <std::size_t which>
void compare_precisions() {
  const auto polynomial = test::random_polynomial(4, 10);
  const Damping damping{.alpha = 0.1, .beta = 0.002, .ratio = {}};
  const VectorXd z = some(4, 0.1);
  auto wide = test::start(polynomial, test::implicit_methods<double>()[which], 0.1, z, 0.05, damping);
  auto narrow = test::start(polynomial, test::implicit_methods<float>()[which], 0.1, z, 0.05, damping);
  double largest = 0, error = 0;
  for (int n = 0; n < 10000; ++n) {
    ASSERT_EQ(wide.step().status, Status::done);
    ASSERT_EQ(narrow.step().status, Status::done);
    largest = std::max(largest, wide.state.z().norm());
    error = std::max(error, (narrow.state.z().cast<double>() - wide.state.z()).norm());
  }
  EXPECT_LE(error, 1e-4 * largest) << wide.workspace.method.name;
}

TEST(NonlinearStep, SinglePrecisionFollowsDouble) {
  compare_precisions<0>();
  compare_precisions<1>();
  compare_precisions<2>();
  compare_precisions<3>();
  compare_precisions<4>();
}

}  // namespace
}  // namespace ritz::runtime
