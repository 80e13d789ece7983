// The derivative of a step against differences of steps, for every integrator and every part of the equation.
#include "ritz/runtime/step.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/nonlinear_support.hpp"

namespace ritz::runtime {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index r = 4;

/// A step as a function of all that it depends on, [y, f_n, f_{n+1}].
template <class Scalar>
struct Function {
  test::Motion<Scalar> motion;
  const PositionForce<Scalar>* position = nullptr;

  Index width() const { return motion.state.history.size(); }

  Vector<Scalar> start() const {
    Vector<Scalar> x(width() + 2 * r);
    x.head(width()) = Eigen::Map<const Vector<Scalar>>(motion.state.history.data(), width());
    x.tail(2 * r) = Vector<Scalar>::LinSpaced(2 * r, Scalar(0.5), Scalar(-1));
    return x;
  }

  Vector<Scalar> operator()(const Vector<Scalar>& x, StepDerivative<Scalar>* derivative = nullptr,
                            int* halved = nullptr) {
    auto state = motion.state;
    Eigen::Map<Vector<Scalar>>(state.history.data(), width()) = x.head(width());
    const Vector<Scalar> begin = x.segment(width(), r), end = x.tail(r);
    const StepLoad<Scalar> load{begin, end, position};
    const auto outcome = derivative ? step<Scalar>(motion.model, state, load, motion.dt, motion.workspace, *derivative)
                                    : step<Scalar>(motion.model, state, load, motion.dt, motion.workspace);
    EXPECT_EQ(outcome.status, Status::done);
    if (halved) *halved = outcome.rejected;
    return Eigen::Map<const Vector<Scalar>>(state.history.data(), width());
  }
};

/// The largest difference of a column from central differences of `side`, of the largest entry of the derivative.
template <class Scalar>
double error(Function<Scalar> function, double side, int* halved = nullptr) {
  const auto x = function.start();
  StepDerivative<Scalar> derivative;
  function(x, &derivative, halved);
  Matrix<Scalar> whole(function.width(), x.size());
  whole << derivative.state, derivative.begin, derivative.end;
  double worst = 0;
  for (Index i = 0; i < x.size(); ++i) {
    const Scalar h = Scalar(side) * std::max(Scalar(1), std::abs(x[i]));
    const Vector<Scalar> way = h * Vector<Scalar>::Unit(x.size(), i);
    const Vector<Scalar> slope = (function(x + way) - function(x - way)) / (2 * h);
    worst = std::max(worst, double((slope - whole.col(i)).cwiseAbs().maxCoeff()));
  }
  return worst / double(whole.cwiseAbs().maxCoeff());
}

const Damping damping{.alpha = .3, .beta = .02, .ratio = {}};

/// After some steps, so that the history is that of a motion.
template <class Scalar>
Function<Scalar> moving(Model<Scalar> model, const Integrator& integrator, const NewtonOptions<Scalar>& options = {},
                        double dt = 0.05, const PositionForce<Scalar>* position = nullptr) {
  auto motion = test::start<Scalar>(std::move(model), integrator, dt, VectorXd::LinSpaced(r, .6, -.4), .5, options,
                                    position ? Loads::of_position : Loads::of_time);
  for (int n = 0; n < 3; ++n) motion.step();
  return {std::move(motion), position};
}

TEST(StepDerivative, OfEveryIntegratorAgreesWithDifferences) {
  for (const auto& integrator : test::all_methods()) {
    const auto model = make_model<double>(test::random_polynomial(r), damping);
    EXPECT_LE(error(moving(model, integrator), 1e-5), 1e-8) << integrator.name;
  }
}

TEST(StepDerivative, OfALinearisedStepHasTheSecondDerivativeOfTheForce) {
  const auto model = make_model<double>(test::random_polynomial(r, 6), damping);
  auto function = moving(model, linearly_implicit(), {}, 0.07);
  EXPECT_LE(error(function, 1e-5), 1e-8);
  StepDerivative<double> own, converged;
  function(function.start(), &own);
  const auto outcome = [&] {
    auto state = function.motion.state;
    const VectorXd x = function.start();
    const VectorXd begin = x.segment(function.width(), r), end = x.tail(r);
    return step<double>(model, state, {begin, end}, function.motion.dt, function.motion.workspace);
  }();
  ASSERT_EQ(outcome.evaluations, 1);
  function.motion.workspace = make_workspace<double>(model, generalized_alpha(), function.motion.dt);
  function(function.start(), &converged);
  EXPECT_GT((own.state - converged.state).norm(), 1e-4 * own.state.norm());
}

TEST(StepDerivative, InSinglePrecision) {
  for (const auto& integrator : test::all_methods()) {
    const auto model = make_model<float>(test::random_polynomial(r), damping);
    EXPECT_LE(error(moving(model, integrator), 2e-2), 3e-3) << integrator.name;
  }
}

TEST(StepDerivative, GoesThroughTheHalvesOfARejectedStep) {
  for (const auto& integrator : test::implicit_methods()) {
    const auto model = make_model<double>(test::random_polynomial(r, 20), damping);
    int halved = 0;
    EXPECT_LE(error(moving<double>(model, integrator, {.iterations = 3}, 1.0), 1e-5, &halved), 1e-6) << integrator.name;
    EXPECT_GT(halved, 0) << integrator.name;
  }
}

TEST(StepDerivative, OfOscillatorsIsTheirTable) {
  const Model<double> model{.force = LinearForce<double>{VectorXd::LinSpaced(r, 0, 90)},
                            .damping = VectorXd(VectorXd::LinSpaced(r, .1, 2))};
  for (const auto& integrator : {exact(), implicit_euler(), newmark(), generalized_alpha(), bdf2(),
                                 central_difference(), avf(), linearly_implicit()})
    EXPECT_LE(error(moving(model, integrator), 1e-3), 1e-11) << integrator.name;
}

TEST(StepDerivative, KnowsForcesThatDependOnThePosition) {
  const PositionForce<double> spring = [](const Configuration<double>& at, double s, VectorXd& force,
                                          Eigen::MatrixXd& tangent) {
    const auto& q = at.q;
    force = -(1 + s) * q.array().cube().matrix();
    tangent = (-3 * (1 + s) * q.array().square()).matrix().asDiagonal();
  };
  const auto polynomial = make_model<double>(test::random_polynomial(r), damping);
  const Model<double> linear{.force = LinearForce<double>{VectorXd::LinSpaced(r, 0, 90)},
                             .damping = VectorXd(VectorXd::LinSpaced(r, .1, 2))};
  for (const auto& integrator : test::all_methods())
    for (const auto& model : {polynomial, linear})
      EXPECT_LE(error(moving<double>(model, integrator, {}, .05, &spring), 1e-5), 1e-7) << integrator.name;
}

TEST(StepDerivative, KnowsAnyInertia) {
  auto heavy = make_model<double>(test::random_polynomial(r), damping);
  const Eigen::MatrixXd mass = Eigen::VectorXd::LinSpaced(r, 1, 3).asDiagonal();
  heavy.inertia = ConstantInertia<double>{mass + .2 * Eigen::MatrixXd::Ones(r, r)};
  auto varying = heavy;
  // M = (2 + q·q) I with the Coriolis force h = 2 (q·v) v − (v·v) q of its kinetic energy.
  varying.inertia = VaryingInertia<double>{[](const auto& q, const auto& v, const auto& a, InertiaAt<double>& at) {
    const double m = 2 + q.squaredNorm();
    at.mass = m * Eigen::MatrixXd::Identity(r, r);
    at.force = m * a + 2 * q.dot(v) * v - v.squaredNorm() * q;
    at.by_position = 2 * a * q.transpose() + 2 * v * v.transpose();
    at.by_position.diagonal().array() -= v.squaredNorm();
    at.by_velocity = 2 * v * q.transpose() - 2 * q * v.transpose();
    at.by_velocity.diagonal().array() += 2 * q.dot(v);
  }};
  for (const auto& integrator : test::all_methods())
    for (const auto& model : {heavy, varying})
      EXPECT_LE(error(moving<double>(model, integrator), 1e-5), 1e-7) << integrator.name;
}

TEST(StepDerivative, IsNotTouchedByAStepThatFails) {
  auto function = moving(make_model<double>(test::random_polynomial(r), damping), avf(), {.iterations = 0});
  StepDerivative<double> derivative{.state = Eigen::MatrixXd::Constant(1, 1, 7), .begin = {}, .end = {}};
  auto& motion = function.motion;
  const auto outcome =
      step<double>(motion.model, motion.state, {motion.force, motion.force}, motion.dt, motion.workspace, derivative);
  EXPECT_EQ(outcome.status, Status::not_converged);
  EXPECT_EQ(derivative.state(0, 0), 7);
}

}  // namespace
}  // namespace ritz::runtime
