#include "ritz/runtime/step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ritz/base/error.hpp"
#include "runtime/nonlinear_support.hpp"

namespace ritz::runtime {
namespace {

using Eigen::VectorXd;

VectorXd some(Eigen::Index r, double size = 1) { return size * VectorXd::LinSpaced(r, 1, -0.6); }

/// z(1) of a damped body that starts from a large deflection under a force.
VectorXd after_one_second(const Integrator& method, int steps) {
  auto motion = test::start(test::random_polynomial(4, 6), method, 1.0 / steps, some(4, 0.8), 0.5,
                            {.alpha = 0.2, .beta = 0.01, .ratio = {}});
  for (int n = 0; n < steps; ++n) EXPECT_EQ(motion.step().status, Status::done);
  return motion.state.z();
}

TEST(NonlinearStep, HasItsOrder) {
  const VectorXd exact = after_one_second(avf(), 40000);
  for (const auto& method : test::all_methods()) {
    const double coarse = (after_one_second(method, 400) - exact).norm();
    const double fine = (after_one_second(method, 800) - exact).norm();
    EXPECT_NEAR(std::log2(coarse / fine), method.name == "implicit-euler" ? 1 : 2, 0.1) << method.name;
  }
}

TEST(NonlinearStep, AvfKeepsTheEnergyOfStiffLargeMotions) {
  const Eigen::Index r = 4;
  const double stiffest = 260, dt = 0.1;  // Δt ω_max = 26
  auto motion = test::start(test::random_polynomial(r, stiffest), avf(), dt, some(r));
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
  auto motion = test::start(test::random_polynomial(4, 260), avf(), 1e3 / 260, some(4));
  const double begin = motion.energy();
  for (int n = 0; n < 2000; ++n) ASSERT_EQ(motion.step().status, Status::done) << n;
  EXPECT_NEAR(motion.energy(), begin, 1e-8 * begin);
}

TEST(NonlinearStep, AvfChangesTheEnergyByTheWorkOfTheLoad) {
  auto motion = test::start(test::random_polynomial(5), avf(), 0.3, some(5), 2.0);
  double work = motion.energy();
  for (int n = 0; n < 200; ++n) {
    const VectorXd before = motion.state.z();
    motion.step();
    work += motion.force.dot(motion.state.z() - before);
    ASSERT_NEAR(motion.energy(), work, 1e-9 * std::abs(work));
  }
}

TEST(NonlinearStep, DissipativeMethodsDoNotGainEnergy) {
  for (const auto& method : {implicit_euler(), bdf2()})
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
  auto motion = test::start(polynomial, implicit_euler(), 0.01, some(4));
  for (double last = motion.energy(); motion.energy() > 1e-12; last = motion.energy()) {
    motion.step();
    ASSERT_LE(motion.energy(), last * (1 + 1e-12));
  }
}

TEST(NonlinearStep, OfALinearPolynomialIsTheLinearStep) {
  const auto polynomial = test::linear_part(test::duffing(9, 1));
  const Damping damping{.alpha = 0.3, .beta = 0.02, .ratio = {}};
  const Model<double> linear{.force = LinearForce<double>{VectorXd::Constant(1, 9)},
                             .damping = VectorXd(VectorXd::Constant(1, 0.3 + 0.02 * 9))};
  const VectorXd z = VectorXd::Ones(1);
  for (const auto& method : test::all_methods()) {
    auto motion = test::start(polynomial, method, 0.05, z, 1.0, damping);
    auto same = test::start(linear, method, 0.05, z, 1.0);
    for (int n = 0; n < 100; ++n) {
      const VectorXd begin = VectorXd::Constant(1, 1 + 0.1 * n), end = VectorXd::Constant(1, 1.1 + 0.1 * n);
      step<double>(motion.model, motion.state, {begin, end}, 0.05, motion.workspace);
      step<double>(same.model, same.state, {begin, end}, 0.05, same.workspace);
    }
    EXPECT_LE((motion.state.history - same.state.history).norm(), 1e-11 * same.state.history.norm()) << method.name;
  }
}

TEST(NonlinearStep, OfAReducedBasisDampingIsStoredAsItsDiagonal) {
  const Damping damping{.alpha = 0.3, .beta = 0.02, .ratio = {}};
  auto polynomial = test::random_polynomial(3);
  polynomial.quadratic << 4, 1e-15, -1e-15, 9, 1e-15, 16;
  const auto model = make_model<double>(polynomial, damping);
  ASSERT_TRUE(std::holds_alternative<VectorXd>(model.damping));
  EXPECT_EQ(std::get<VectorXd>(model.damping), VectorXd(0.3 + 0.02 * Eigen::Array3d(4, 9, 16)));
  polynomial.quadratic[1] = 1e-9;  // more than rounding
  const auto full = make_model<double>(polynomial, damping);
  ASSERT_TRUE(std::holds_alternative<Eigen::MatrixXd>(full.damping));
  EXPECT_EQ(std::get<Eigen::MatrixXd>(full.damping)(1, 0), 0.02 * 1e-9);
}

TEST(NonlinearStep, GoesOnFromAStoredStateBitByBit) {
  for (const auto& method : test::all_methods()) {
    auto motion = test::start(test::random_polynomial(6), method, 0.05, some(6), 1.0);
    for (int n = 0; n < 20; ++n) motion.step();
    auto later = test::start(test::random_polynomial(6), method, 0.05, some(6, 0.1), 1.0);
    later.state = motion.state;
    for (int n = 0; n < 20; ++n) motion.step(), later.step();
    EXPECT_EQ(motion.state.history, later.state.history) << method.name;
  }
}

template <std::size_t which>
void compare_precisions() {
  const auto polynomial = test::random_polynomial(4, 10);
  const Damping damping{.alpha = 0.1, .beta = 0.002, .ratio = {}};
  const VectorXd z = some(4, 0.1);
  auto wide = test::start(polynomial, test::implicit_methods()[which], 0.1, z, 0.05, damping);
  auto narrow = test::start<float>(polynomial, test::implicit_methods()[which], 0.1, z, 0.05, damping);
  double largest = 0, error = 0;
  for (int n = 0; n < 10000; ++n) {
    ASSERT_EQ(wide.step().status, Status::done);
    ASSERT_EQ(narrow.step().status, Status::done);
    largest = std::max(largest, wide.state.z().norm());
    error = std::max(error, (narrow.state.z().cast<double>() - wide.state.z()).norm());
  }
  EXPECT_LE(error, 1e-4 * largest) << wide.workspace.integrator.name;
}

TEST(NonlinearStep, SinglePrecisionFollowsDouble) {
  compare_precisions<0>();
  compare_precisions<1>();
  compare_precisions<2>();
  compare_precisions<3>();
  compare_precisions<4>();
  compare_precisions<5>();
}

}  // namespace
}  // namespace ritz::runtime
