// Bodies that a rigid frame carries: free flight against closed forms, and the derivative of a step against
// differences.
#include "ritz/runtime/frame.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "ritz/runtime/step.hpp"
#include "runtime/nonlinear_support.hpp"

namespace ritz::runtime {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double top_mass = 2;
const Vector3d top_moments(.5, .5, .2);  ///< of a symmetric top about its centre of mass, kg m²
const Vector3d fall_rate(0, 0, -9.81);

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// Newton's and Euler's equations of a rigid body about its centre of mass, beside z'' of what vibrates on it.
const VaryingInertia<double> top{[](const auto&, const auto& nu, const auto& a, InertiaAt<double>& at) {
  const Vector3d v = nu.template head<3>(), w = nu.template segment<3>(3), spin = top_moments.cwiseProduct(w);
  at.mass.setIdentity();
  at.mass.diagonal().template head<3>().setConstant(top_mass);
  at.mass.diagonal().template segment<3>(3) = top_moments;
  at.force = at.mass.diagonal().cwiseProduct(a);
  at.force.template head<3>() += top_mass * w.cross(v);
  at.force.template segment<3>(3) += w.cross(spin);
  at.by_position.setZero();
  at.by_velocity.setZero();
  at.by_velocity.template block<3, 3>(0, 0) = top_mass * cross_matrix(w);
  at.by_velocity.template block<3, 3>(0, 3) = -top_mass * cross_matrix(v);
  at.by_velocity.template block<3, 3>(3, 3) = cross_matrix(w) * top_moments.asDiagonal() - cross_matrix(spin);
}};

const PositionForce<double> weight_of_top = [](const Configuration<double>& at, double, VectorXd& force,
                                               MatrixXd& tangent) {
  const Vector3d own = top_mass * (at.carrier->rotation.conjugate() * fall_rate);
  force.setZero();
  force.head<3>() = own;
  tangent.setZero();
  tangent.block<3, 3>(0, 3) = cross_matrix(own);
};

const Vector3d thrown(1, -2, 3), spun(.7, -.4, 5);

Model<double> flying(Index r) { return carry<double>(make_model<double>(test::random_polynomial(r), {}), top); }

struct Flight {
  Model<double> model;
  State<double> state;
  Workspace<double> workspace;
  double dt;
  VectorXd none = VectorXd::Zero(model.size());

  Outcome step() { return runtime::step<double>(model, state, {none, none, &weight_of_top}, dt, workspace); }
};

Flight launched(Index r, const Integrator& integrator, double dt) {
  auto model = flying(r);
  VectorXd z = VectorXd::Zero(model.size()), nu = z, load = z;
  z.tail(r).setConstant(.1);
  nu.head<6>() << thrown, spun;
  load.head<3>() = top_mass * fall_rate;
  auto state = make_state<double>(model, integrator, z, nu, load);
  auto workspace = make_workspace<double>(model, integrator, dt, {}, Loads::of_position);
  return {std::move(model), std::move(state), std::move(workspace), dt};
}

/// After a second, from a frame at rest: the centre falls, the axis precesses about the angular momentum.
Frame<double> exact_flight() {
  const Vector3d momentum = top_moments.cwiseProduct(spun);
  const double about_itself = spun.z() * (1 - top_moments.z() / top_moments.x());
  const Vector3d precession = momentum / top_moments.x();
  const auto turn = [](const Vector3d& angle) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle.norm(), angle.normalized()));
  };
  return {thrown + fall_rate / 2, turn(precession) * turn(about_itself * Vector3d::UnitZ())};
}

TEST(Frame, FliesAndPrecessesWithEachMethodsOrder) {
  const auto truth = exact_flight();
  for (const auto& integrator : test::all_methods()) {
    std::array<double, 2> fall{}, turn{};
    for (const std::size_t i : {0U, 1U}) {
      const int steps = i == 0 ? 400 : 800;
      auto flight = launched(1, integrator, 1.0 / steps);
      for (int n = 0; n < steps; ++n) ASSERT_EQ(flight.step().status, Status::done) << integrator.name;
      fall[i] = (flight.state.frame->origin - truth.origin).norm();
      turn[i] = flight.state.frame->rotation.angularDistance(truth.rotation);
      EXPECT_NEAR(flight.state.frame->rotation.norm(), 1, 1e-15);
      EXPECT_TRUE(flight.state.z().head<6>().isZero(0));
    }
    const double order = integrator.name == "implicit-euler" ? 1 : 2;
    EXPECT_NEAR(std::log2(turn[0] / turn[1]), order, .15) << integrator.name << ' ' << turn[1];
    EXPECT_NEAR(std::log2(fall[0] / fall[1]), order, .15) << integrator.name << ' ' << fall[1];
    EXPECT_LT(turn[1], order == 1 ? .1 : 1e-3) << integrator.name;
    EXPECT_LT(fall[1], order == 1 ? .1 : 1e-3) << integrator.name;
  }
}

TEST(Frame, LeavesTheVibrationOfABodyWithoutCouplingAlone) {
  for (const auto& integrator : test::all_methods()) {
    auto flight = launched(3, integrator, .01);
    auto alone = test::start<double>(make_model<double>(test::random_polynomial(3), {}), integrator, .01,
                                     VectorXd::Constant(3, .1));
    for (int n = 0; n < 100; ++n) {
      flight.step();
      alone.step();
    }
    const double once = integrator.name == "linearly-implicit" ? 1e-8 : 0;  // it iterates where the inertia varies
    EXPECT_LE((flight.state.z().tail(3) - alone.state.z()).norm(), 1e-9 + once) << integrator.name;
  }
}

/// What small motion of `from`, by its axes, leads to `to`.
Eigen::Matrix<double, 6, 1> small_motion(const Frame<double>& from, const Frame<double>& to) {
  const Eigen::AngleAxisd turn(from.rotation.conjugate() * to.rotation);
  Eigen::Matrix<double, 6, 1> small;
  small << from.rotation.conjugate() * (to.origin - from.origin), turn.angle() * turn.axis();
  return small;
}

TEST(Frame, FollowsItsChangeAndTheFrameBefore) {
  Frame<double> frame = exact_flight();
  for (const double size : {1e-6, .3, 2.0}) {
    FrameChange<double> change;
    change << .4, -.2, .3, .5, .1, -.7;
    change *= size;
    const auto derivative = moved_derivative<double>(change);
    const auto there = moved(frame, change);
    constexpr double h = 1e-6;
    for (Index i = 0; i < frame_coordinates; ++i) {
      const FrameChange<double> small = h * FrameChange<double>::Unit(i);
      const FrameChange<double> by_change = (small_motion(there, moved<double>(frame, change + small)) -
                                             small_motion(there, moved<double>(frame, change - small))) /
                                            (2 * h);
      const FrameChange<double> by_frame = (small_motion(there, moved<double>(moved<double>(frame, small), change)) -
                                            small_motion(there, moved<double>(moved<double>(frame, -small), change))) /
                                           (2 * h);
      EXPECT_LE((by_change - derivative.by_change.col(i)).norm(), 1e-8) << size << ' ' << i;
      EXPECT_LE((by_frame - derivative.by_frame.col(i)).norm(), 1e-8) << size << ' ' << i;
    }
  }
}

/// The state after a step from `state`, whose frame and history are changed by h along component i of all.
State<double> perturbed_step(Flight& flight, const State<double>& from, Index i, double h) {
  auto state = from;
  if (i < frame_coordinates) state.frame = moved<double>(*state.frame, h * FrameChange<double>::Unit(i));
  else state.history.reshaped()[i] += h;
  EXPECT_EQ(
      step<double>(flight.model, state, {flight.none, flight.none, &weight_of_top}, flight.dt, flight.workspace).status,
      Status::done);
  return state;
}

TEST(Frame, IsKnownToTheDerivativeOfAStep) {
  for (const auto& integrator : test::all_methods()) {
    auto flight = launched(2, integrator, .02);
    for (int n = 0; n < 5; ++n) flight.step();
    const auto from = flight.state;
    auto there = from;
    StepDerivative<double> derivative;
    step<double>(flight.model, there, {flight.none, flight.none, &weight_of_top}, flight.dt, flight.workspace,
                 derivative);
    constexpr double h = 1e-5;
    const double scale = derivative.state.cwiseAbs().maxCoeff();
    for (Index i = 0; i < from.history.size(); ++i) {
      const auto plus = perturbed_step(flight, from, i, h), minus = perturbed_step(flight, from, i, -h);
      VectorXd slope = (plus.history - minus.history).reshaped() / (2 * h);
      slope.head<frame_coordinates>() =
          (small_motion(*there.frame, *plus.frame) - small_motion(*there.frame, *minus.frame)) / (2 * h);
      EXPECT_LE((slope - derivative.state.col(i)).cwiseAbs().maxCoeff(), 1e-7 * scale) << integrator.name << ' ' << i;
    }
  }
}

TEST(Frame, IsRestoredByAStepThatFails) {
  auto flight = launched(2, avf(), .02);
  flight.step();
  flight.workspace.options.iterations = 0;
  const auto before = flight.state;
  EXPECT_EQ(flight.step().status, Status::not_converged);
  EXPECT_EQ(flight.state.history, before.history);
  EXPECT_EQ(flight.state.frame->origin, before.frame->origin);
  EXPECT_EQ(flight.state.frame->rotation.coeffs(), before.frame->rotation.coeffs());
}

TEST(Frame, BelongsToTheStateOfACarriedBodyAlone) {
  auto flight = launched(2, avf(), .02);
  flight.state.frame.reset();
  EXPECT_THROW(flight.step(), std::logic_error);
  auto held = test::start<double>(make_model<double>(test::random_polynomial(2), {}), avf(), .02, VectorXd::Ones(2));
  held.state.frame.emplace();
  EXPECT_THROW(held.step(), std::logic_error);
}

TEST(Frame, CarriesABodyOfSmallDisplacements) {
  const VectorXd stiffness = Vector3d(4, 9, 400);
  const Model<double> body{.force = LinearForce<double>{stiffness}, .damping = VectorXd(VectorXd::Constant(3, .1))};
  const auto carried = carry<double>(body, top);
  const VectorXd at_rest = stiffness_at_rest(carried.force).diagonal();
  EXPECT_TRUE(at_rest.head<6>().isZero(0));
  EXPECT_EQ(at_rest.tail(3), stiffness);
  VectorXd start = VectorXd::Zero(9);
  start.tail(3).setOnes();
  auto flying_body = test::start<double>(carried, newmark(), .01, start);
  auto alone = test::start<double>(body, newmark(), .01, VectorXd::Ones(3));
  for (int n = 0; n < 50; ++n) {
    ASSERT_EQ(flying_body.step().status, Status::done);
    alone.step();
  }
  EXPECT_LE((flying_body.state.z().tail(3) - alone.state.z()).norm(), 1e-12);
  EXPECT_NEAR(flying_body.energy(), alone.energy(), 1e-10 * alone.energy());
}

TEST(Frame, IsTheSameInSinglePrecision) {
  FrameChange<double> change;
  change << .4, -.2, .3, .5, .1, -.7;
  for (const double size : {1e-6, 1e-3, .02, 1.0}) {
    const FrameChange<double> exact = size * change;
    const auto single = moved_derivative<float>(exact.cast<float>());
    const auto reference = moved_derivative<double>(exact);
    EXPECT_LE((single.by_change.cast<double>() - reference.by_change).norm(), 1e-6) << size;
    EXPECT_LE((single.by_frame.cast<double>() - reference.by_frame).norm(), 1e-6) << size;
    const auto to = moved<float>({}, exact.cast<float>());
    EXPECT_LE((to.origin.cast<double>() - moved<double>({}, exact).origin).norm(), 1e-6 * size);
  }
}

}  // namespace
}  // namespace ritz::runtime
