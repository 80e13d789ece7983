// The exact recurrence against the exponential of the augmented system in extended precision, and closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ritz/runtime/step.hpp"

namespace ritz::runtime {
namespace {

using Long = long double;
using Matrix4 = Eigen::Matrix<Long, 4, 4>;

OscillatorStep exact_step(double stiffness, double damping, double dt) {
  return oscillator_step(exact(), StepKind::later, stiffness, damping, dt);
}

/// exp by Taylor series, scaling and squaring.
Matrix4 exponential(Matrix4 m) {
  int squarings = 0;
  for (; m.cwiseAbs().maxCoeff() > Long(0.0625); ++squarings) m /= 2;
  Matrix4 sum = Matrix4::Identity(), term = sum;
  for (int n = 1; n < 20; ++n) sum += term = term * m / Long(n);
  for (; squarings > 0; --squarings) sum = sum * sum;
  return sum;
}

/// d/dτ [x, x', f, Δf] over a unit step, with x' per step and f times Δt². What decays is computed without its decay,
/// so that it is right relative to what is left of it.
Matrix4 reference(Long K, Long C) {
  Matrix4 m = Matrix4::Zero();
  m.row(0) << 0, 1, 0, 0;
  m.row(1) << -K, -C, 1, 0;
  m(2, 3) = 1;
  Matrix4 E = exponential(m);
  E.leftCols(2) = std::exp(-C / 2) * exponential(m + C / 2 * Matrix4::Identity()).leftCols(2);
  return E;
}

/// The state that a step makes of each unit state and force, against the size of that same state: its energy's root,
/// or for slow modes the way and its rate, per step.
void expect_step(double K, double C, double dt) {
  const double lambda = K / (dt * dt), d = C / dt, h = dt, omega = std::max(std::sqrt(K), 1.0);
  const Matrix4 E = reference(Long(lambda) * dt * dt, Long(d) * dt);
  const OscillatorStep s = exact_step(lambda, d, dt);
  Eigen::Matrix<Long, 2, 4> got;
  got << s.A(0, 0), s.A(0, 1) / h, (s.b[0] + s.c[0]) / (h * h), s.c[0] / (h * h),  //
      s.A(1, 0) * h, s.A(1, 1), (s.b[1] + s.c[1]) / h, s.c[1] / h;
  for (int j = 0; j < 4; ++j) {
    const auto size = [&](const Eigen::Matrix<Long, 2, 1>& x) { return std::hypot(omega * x[0], x[1]); };
    EXPECT_LE(size(got.col(j) - E.col(j).head<2>()), 1e-13 * size(E.col(j).head<2>()))
        << "K " << K << " C " << C << " dt " << dt << " from " << j;
  }
}

TEST(Exact, AgreesWithTheMatrixExponential) {
  for (const double K : {0., 1e-300, 1e-20, 1e-12, 1e-6, 1e-3, .1, .5, 1., 1.9999, 2.0001, 5., 9.8696, 30., 100., 900.})
    for (const double C : {0., 1e-20, 1e-9, 1e-3, .1, .9, 1.9999, 2.0001, 3., 6., 12., 25.})
      for (const double dt : {1., 1e-4}) expect_step(K, C, dt);
}

TEST(Exact, IsSmoothThroughCriticalDamping) {
  for (const double C : {1e-4, .5, 1.99, 2.01, 4., 10., 30.})
    for (const double detuning : {0., 1e-16, 1e-14, 1e-12, 1e-8, 1e-5, 1e-3, .1})
      for (const double sign : {-1., 1.}) expect_step(C * C / 4 * (1 + sign * detuning), C, .01);
}

TEST(Exact, KeepsThePhaseOfAHugeStep) {
  for (const double theta : {1e2, 1e3, 1e4}) {
    const double omega = 2 * M_PI * 440, dt = theta / omega;
    const OscillatorStep s = exact_step(omega * omega, 0, dt);
    const Long phase = std::sqrt(Long(omega * omega)) * dt;
    EXPECT_NEAR(s.A(0, 0), static_cast<double>(std::cos(phase)), 1e-13);
    EXPECT_NEAR(s.A(0, 1) * omega, static_cast<double>(std::sin(phase)), 1e-13);
    EXPECT_NEAR(s.A(1, 0) / omega, -static_cast<double>(std::sin(phase)), 1e-13);
  }
}

TEST(Exact, FollowsASlowModeUnderHugeDamping) {
  // d = 1e8/s, λ = 1e4 rad²/s²: the fast motion is gone at once, the slow root is -1e-4/s but for 1e-12 of it.
  const double lambda = 1e4, d = 1e8, dt = 1000;
  const Long fast = -(d + std::sqrt(Long(d) * d - 4 * lambda)) / 2, slow = lambda / fast;
  const Long left = std::exp(slow * dt) * fast / (fast - slow);
  const OscillatorStep s = exact_step(lambda, d, dt);
  EXPECT_NEAR(s.A(0, 0), static_cast<double>(left), 1e-13);
  EXPECT_NEAR((s.b[0] + s.c[0]) * lambda, static_cast<double>(1 - left), 1e-13 * static_cast<double>(1 - left));
  EXPECT_TRUE(s.A.allFinite() && s.b.allFinite() && s.c.allFinite());
}

TEST(Exact, SettlesAtTheStaticAnswerAfterAnEndlessStep) {
  for (const double damping : {1e3, 2e4, 1e9}) {
    const OscillatorStep s = exact_step(1e8, damping, 1e9);
    EXPECT_NEAR(s.A(0, 0), 0, 1e-13) << damping;
    EXPECT_NEAR((s.b[0] + s.c[0]) * 1e8, 1, 1e-13) << damping;
  }
}

TEST(Exact, RigidModeFallsFreely) {
  const OscillatorStep s = exact_step(0, 0, .5);
  EXPECT_DOUBLE_EQ(s.A(0, 0), 1);
  EXPECT_DOUBLE_EQ(s.A(0, 1), .5);
  EXPECT_DOUBLE_EQ(s.A(1, 0), 0);
  EXPECT_DOUBLE_EQ(s.A(1, 1), 1);
  EXPECT_DOUBLE_EQ(s.b[0], .25 / 3);
  EXPECT_DOUBLE_EQ(s.c[0], .25 / 6);
  EXPECT_DOUBLE_EQ(s.b[1], .25);
  EXPECT_DOUBLE_EQ(s.c[1], .25);
}

TEST(Exact, TwoHalfStepsAreOneStep) {
  for (const double C : {0., .3, 3., 50.}) {
    const OscillatorStep whole = exact_step(7, C, 1), half = exact_step(7, C, .5);
    EXPECT_LT((half.A * half.A - whole.A).cwiseAbs().maxCoeff(), 1e-14) << C;
    // A force of 1 held over both halves.
    const Eigen::Vector4d once = half.b + half.c;
    EXPECT_LT((half.A * once + once - (whole.b + whole.c)).cwiseAbs().maxCoeff(), 1e-14) << C;
  }
}

/// z'' + d z' + λ z = f₀ + f₁ t from rest, by undetermined coefficients.
double closed_form(double lambda, double d, double f0, double f1, double t) {
  const double slope = f1 / lambda, offset = (f0 - d * slope) / lambda;
  const double z0 = -offset, v0 = -slope, a = d / 2, disc = lambda - a * a;
  if (disc == 0) return offset + slope * t + std::exp(-a * t) * (z0 + (v0 + a * z0) * t);
  if (disc > 0) {
    const double w = std::sqrt(disc);
    return offset + slope * t + std::exp(-a * t) * (z0 * std::cos(w * t) + (v0 + a * z0) / w * std::sin(w * t));
  }
  const double w = std::sqrt(-disc);
  return offset + slope * t + std::exp(-a * t) * (z0 * std::cosh(w * t) + (v0 + a * z0) / w * std::sinh(w * t));
}

TEST(Exact, FollowsTheClosedFormThroughAThousandSteps) {
  const Eigen::VectorXd stiffness = Eigen::Vector4d(4, 4, 4, 100), damping = Eigen::Vector4d(.2, 4, 9, 0);
  const Model<double> model{.force = LinearForce<double>{stiffness}, .damping = damping};
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(4);
  auto state = make_state<double>(model, exact(), rest, rest, rest);
  const double dt = .01;
  auto workspace = make_workspace<double>(model, exact(), dt);
  const auto force = [](double t) { return Eigen::VectorXd::Constant(4, 3 - .5 * t); };
  for (int n = 0; n < 1000; ++n) {
    const Eigen::VectorXd begin = force(n * dt), end = force((n + 1) * dt);
    ASSERT_EQ(step<double>(model, state, {begin, end}, dt, workspace).status, Status::done);
  }
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(state.z()[i], closed_form(stiffness[i], damping[i], 3, -.5, 10), 2e-12) << i;
}

}  // namespace
}  // namespace ritz::runtime
