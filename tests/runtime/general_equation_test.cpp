// M(q) q̈ + D q̇ + f̃(q) = F(q, t) beyond the identity mass and loads of time: closed forms and conservation.
#include <gtest/gtest.h>

#include <cmath>

#include "ritz/base/error.hpp"
#include "runtime/nonlinear_support.hpp"

namespace ritz::runtime {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// The polynomial in the coordinates z = T q.
model::Polynomial bar(double stiffness) {
  return {1, VectorXd::Constant(1, stiffness), VectorXd::Constant(1, 3 * stiffness),
          VectorXd::Constant(1, 3 * stiffness)};
}

TEST(GeneralEquation, AConstantMassIsAChangeOfUnits) {
  // m q'' + m d q' + f(q) = m F is q'' + d q' + f(q)/m = F.
  const double m = 7;
  for (const auto& integrator : test::all_methods()) {
    auto light = make_model<double>(bar(9), {.alpha = .1, .beta = 0, .ratio = {}});
    auto heavy = make_model<double>(bar(9 * m), {.alpha = .1 * m, .beta = 0, .ratio = {}});
    heavy.inertia = ConstantInertia<double>{MatrixXd::Constant(1, 1, m)};
    auto one = test::start<double>(light, integrator, .05, VectorXd::Constant(1, .3), 1);
    auto other = test::start<double>(heavy, integrator, .05, VectorXd::Constant(1, .3), m);
    for (int n = 0; n < 200; ++n) {
      ASSERT_EQ(one.step().status, Status::done);
      ASSERT_EQ(other.step().status, Status::done);
    }
    EXPECT_LE((one.state.history - other.state.history).norm(), 1e-10 * one.state.history.norm()) << integrator.name;
    EXPECT_NEAR(other.energy(), m * one.energy(), 1e-10 * other.energy());
  }
}

/// A mass of 1 kg on a massless rod of 1 m, in the coordinates (length − 1, angle): M = diag(1, l²), weight g
/// downwards.
Model<double> pendulum() {
  Model<double> model{.force = LinearForce<double>{Vector2d(400, 0)}, .damping = VectorXd(Vector2d::Zero())};
  model.inertia = VaryingInertia<double>{[](const auto& q, const auto& v, const auto& a, InertiaAt<double>& at) {
    const double l = 1 + q[0];
    at.mass = Vector2d(1, l * l).asDiagonal();
    at.force = Vector2d(a[0] - l * v[1] * v[1], l * l * a[1] + 2 * l * v[0] * v[1]);
    at.by_position << -v[1] * v[1], 0, 2 * l * a[1] + 2 * v[0] * v[1], 0;
    at.by_velocity << 0, -2 * l * v[1], 2 * l * v[1], 2 * l * v[0];
  }};
  return model;
}

constexpr double gravity = 9.81;

const PositionForce<double> weight = [](const Configuration<double>& at, double, VectorXd& force, MatrixXd& tangent) {
  const auto& q = at.q;
  const double l = 1 + q[0], c = std::cos(q[1]), s = std::sin(q[1]);
  force = gravity * Vector2d(c, -l * s);
  tangent << 0, -gravity * s, -gravity * s, -gravity * l * c;
};

double pendulum_energy(const State<double>& state) {
  const double l = 1 + state.z()[0];
  const auto v = state.velocity();
  return (v[0] * v[0] + l * l * v[1] * v[1]) / 2 + 200 * state.z()[0] * state.z()[0] -
         gravity * l * std::cos(state.z()[1]);
}

/// The state at t = 1 from a release at 60 degrees.
State<double> swing(const Integrator& integrator, int steps) {
  const auto model = pendulum();
  const VectorXd z = Vector2d(0, M_PI / 3), rest = Vector2d::Zero();
  VectorXd at_start(2);
  MatrixXd tangent(2, 2);
  weight({z, nullptr}, 0, at_start, tangent);
  const double dt = 1.0 / steps;
  auto state = make_state<double>(model, integrator, z, rest, at_start);
  auto workspace = make_workspace<double>(model, integrator, dt, {}, Loads::of_position);
  for (int n = 0; n < steps; ++n)
    EXPECT_EQ(step<double>(model, state, {rest, rest, &weight}, dt, workspace).status, Status::done);
  return state;
}

TEST(GeneralEquation, AnElasticPendulumHasEachMethodsOrder) {
  const VectorXd truth = swing(avf(), 20000).z();
  for (const auto& integrator : test::all_methods()) {
    const double coarse = (swing(integrator, 500).z() - truth).norm();
    const double fine = (swing(integrator, 1000).z() - truth).norm();
    EXPECT_NEAR(std::log2(coarse / fine), integrator.name == "implicit-euler" ? 1 : 2, 0.15) << integrator.name;
  }
}

TEST(GeneralEquation, AnElasticPendulumKeepsItsEnergy) {
  const auto state = swing(avf(), 20000);
  EXPECT_NEAR(pendulum_energy(state), -gravity / 2, 1e-6);
}

TEST(GeneralEquation, ASpringOnAnOscillatorIsAStifferOscillator) {
  const PositionForce<double> spring = [](const Configuration<double>& at, double, VectorXd& force, MatrixXd& tangent) {
    const auto& q = at.q;
    force = -5 * q;
    tangent = -5 * MatrixXd::Identity(1, 1);
  };
  const Model<double> soft{.force = LinearForce<double>{VectorXd::Constant(1, 4)},
                           .damping = VectorXd(VectorXd::Constant(1, .2))};
  const Model<double> stiff{.force = LinearForce<double>{VectorXd::Constant(1, 9)},
                            .damping = VectorXd(VectorXd::Constant(1, .2))};
  for (const auto& integrator : test::all_methods()) {
    const VectorXd none = VectorXd::Zero(1), z = VectorXd::Ones(1), pulled = VectorXd::Constant(1, -5);
    auto sprung = make_state<double>(soft, integrator, z, none, pulled);
    auto same = make_state<double>(stiff, integrator, z, none, none);
    auto by_newton = make_workspace<double>(soft, integrator, .1, {}, Loads::of_position);
    auto by_table = make_workspace<double>(stiff, integrator, .1);
    for (int n = 0; n < 100; ++n) {
      step<double>(soft, sprung, {none, none, &spring}, .1, by_newton);
      step<double>(stiff, same, {none, none}, .1, by_table);
    }
    EXPECT_LE((sprung.history - same.history).norm(), 1e-11) << integrator.name;
  }
}

TEST(GeneralEquation, TheWorkOfAForceOfPositionIsCounted) {
  const PositionForce<double> spring = [](const Configuration<double>& at, double, VectorXd& force, MatrixXd& tangent) {
    const auto& q = at.q;
    force = -5 * q;
    tangent = -5 * MatrixXd::Identity(q.size(), q.size());
  };
  auto motion = test::start<double>(make_model<double>(test::random_polynomial(3), {}), avf(), .1, VectorXd::Ones(3), 0,
                                    {}, Loads::of_position);
  const double begin = motion.energy();
  double work = 0;
  for (int n = 0; n < 50; ++n)
    work += step<double>(motion.model, motion.state, {motion.force, motion.force, &spring}, .1, motion.workspace).work;
  EXPECT_NEAR(motion.energy() - begin, work, 1e-9 * begin);
  EXPECT_NEAR(work, 2.5 * (3 - motion.state.z().squaredNorm()), 1e-9 * begin);
}

TEST(GeneralEquation, TheExactIntegratorIsForOscillatorsAlone) {
  const auto polynomial = make_model<double>(bar(9), {});
  EXPECT_THROW(make_workspace<double>(polynomial, exact(), .1), InputError);
  const Model<double> oscillator{.force = LinearForce<double>{VectorXd::Ones(1)},
                                 .damping = VectorXd(VectorXd::Zero(1))};
  EXPECT_THROW(make_workspace<double>(oscillator, exact(), .1, {}, Loads::of_position), InputError);
}

TEST(GeneralEquation, AForceOfPositionNeedsAWorkspaceMadeForIt) {
  const PositionForce<double> none = [](const auto&...) {};
  const Model<double> oscillator{.force = LinearForce<double>{VectorXd::Ones(1)},
                                 .damping = VectorXd(VectorXd::Zero(1))};
  for (const auto& model : {oscillator, make_model<double>(bar(9), {})}) {
    auto motion = test::start<double>(model, avf(), .1, VectorXd::Ones(1));
    const StepLoad<double> load{motion.force, motion.force, &none};
    EXPECT_THROW(step<double>(motion.model, motion.state, load, .1, motion.workspace), std::logic_error);
  }
}

TEST(GeneralEquation, AnExplicitStepWhoseInertiaIsNotSolvedForIsRejected) {
  // h = 5 v / Δt: the repeated solution of a + 5 (v + Δt a / 2) / Δt = 0 runs away, as 5/2 > 1.
  auto model = make_model<double>(bar(1), {});
  model.inertia = VaryingInertia<double>{
      [](const auto&, const auto& v, const auto& a, InertiaAt<double>& at) { at.force = a + 50 * v; }};
  auto motion = test::start<double>(model, central_difference(), .1, VectorXd::Ones(1), 0, {.halvings = 0});
  motion.state.history(0, 1) = 1;
  const auto before = motion.state.history;
  EXPECT_EQ(motion.step().status, Status::not_converged);
  EXPECT_EQ(motion.state.history, before);
}

TEST(GeneralEquation, AnExplicitStepIsBoundedByTheMass) {
  auto model = make_model<double>(bar(100), {});
  model.inertia = ConstantInertia<double>{MatrixXd::Constant(1, 1, 4)};  // ω = 5
  EXPECT_NO_THROW(make_workspace<double>(model, central_difference(), .399));
  EXPECT_THROW(make_workspace<double>(model, central_difference(), .401), InputError);
}

}  // namespace
}  // namespace ritz::runtime
