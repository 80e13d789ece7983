// Order of accuracy, energy and stability of the integrators on single oscillators.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "ritz/base/error.hpp"
#include "ritz/runtime/step.hpp"

namespace ritz::runtime {
namespace {

Model<double> oscillators(const Eigen::VectorXd& stiffness, const Eigen::VectorXd& damping) {
  return {.force = LinearForce<double>{stiffness}, .damping = damping};
}

Model<double> oscillator(double lambda, double d) {
  return oscillators(Eigen::VectorXd::Constant(1, lambda), Eigen::VectorXd::Constant(1, d));
}

Eigen::VectorXd number(double x) { return Eigen::VectorXd::Constant(1, x); }

/// z(1) and z'(1) from z = 1, z' = -2 under f = sin 5t.
Eigen::Vector2d at_one_second(const Integrator& integrator, const Model<double>& model, int steps) {
  const double dt = 1. / steps;
  auto state = make_state<double>(model, integrator, number(1), number(-2), number(0));
  auto workspace = make_workspace<double>(model, integrator, dt);
  for (int n = 0; n < steps; ++n)
    step<double>(model, state, {number(std::sin(5 * n * dt)), number(std::sin(5 * (n + 1) * dt))}, dt, workspace);
  return {state.z()[0], state.velocity()[0]};
}

double observed_order(const Integrator& integrator, double lambda, double d) {
  const Model<double> model = oscillator(lambda, d);
  const Eigen::Vector2d truth = at_one_second(exact(), model, 40000);
  const double coarse = (at_one_second(integrator, model, 400) - truth).norm();
  const double fine = (at_one_second(integrator, model, 800) - truth).norm();
  return std::log2(coarse / fine);
}

TEST(Integrators, HaveTheirOrder) {
  for (const auto& [lambda, d] : {std::pair(30., 0.), {30., 1.5}, {4., 8.}, {0., 0.}, {0., 2.}}) {
    EXPECT_NEAR(observed_order(implicit_euler(), lambda, d), 1, .1) << lambda << ' ' << d;
    for (const auto& second :
         {newmark(), generalized_alpha(), bdf2(), central_difference(), avf(), linearly_implicit()})
      EXPECT_NEAR(observed_order(second, lambda, d), 2, .1) << second.name << ' ' << lambda << ' ' << d;
  }
}

/// The energy; of BDF2 after its first step its own norm, (E(y_n) + E(2 y_n - y_{n-1})) / 2 [Dahlquist 1978], since a
/// two-step method may shift a little energy between its two last states.
double norm(const Model<double>& model, const State<double>& state) {
  auto room = make_evaluation(model.force);
  const double now = energy(model, state, room);
  if (state.history.cols() < 4 || state.last_dt == 0) return now;
  const Eigen::VectorXd z = state.z() + state.history.col(2), v = 2 * state.velocity() - state.history.col(3);
  return (now + energy<double>(model, z, v, room)) / 2;
}

/// Norms over `steps` unloaded steps of θ = ωΔt from z, z'.
std::vector<double> energies(const Integrator& integrator, double theta, double ratio, Eigen::Vector2d start,
                             int steps) {
  const Model<double> model = oscillator(theta * theta, 2 * ratio * theta);
  auto state = make_state<double>(model, integrator, number(start[0]), number(start[1]), number(0));
  auto workspace = make_workspace<double>(model, integrator, 1);
  auto room = make_evaluation(model.force);
  std::vector<double> result = {norm(model, state)};
  for (int n = 0; n < steps; ++n) {
    EXPECT_EQ(step<double>(model, state, {number(0), number(0)}, 1, workspace).status, Status::done);
    EXPECT_LE(energy(model, state, room), result.front() * (1 + 1e-10)) << integrator.name;
    result.push_back(norm(model, state));
  }
  return result;
}

TEST(Integrators, BackwardDifferencesNeverGainEnergy) {
  for (const auto& integrator : {implicit_euler(), bdf2()})
    for (double theta = 1e-3; theta < 2e4; theta *= 1.3)
      for (const double ratio : {0., .01, .5, 1., 4.})
        for (const auto& start : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, theta), Eigen::Vector2d(1, -theta)}) {
          const auto e = energies(integrator, theta, ratio, start, 200);
          for (std::size_t n = 1; n < e.size(); ++n)
            ASSERT_LE(e[n], e[n - 1] * (1 + 1e-14)) << integrator.name << ' ' << theta << ' ' << ratio << ' ' << n;
        }
}

TEST(Integrators, NewmarkAndAvfKeepEnergy) {
  for (const auto& integrator : {newmark(), avf(), exact()})
    for (const double theta : {1e-2, 1., 30., 1e3}) {
      const auto e = energies(integrator, theta, 0, {1, .3 * theta}, 10000);
      EXPECT_NEAR(e.back() / e.front(), 1, 1e-10) << integrator.name << ' ' << theta;
    }
}

double spectral_radius(const OscillatorStep& step) { return step.A.eigenvalues().cwiseAbs().maxCoeff(); }

TEST(Integrators, NoModeGrows) {
  for (double theta = 1e-3; theta < 1e5; theta *= 1.7)
    for (const double ratio : {0., .02, .7, 1., 3.})
      for (const auto& integrator : {exact(), implicit_euler(), newmark(), generalized_alpha(), bdf2(), avf()})
        EXPECT_LE(spectral_radius(oscillator_step(integrator, StepKind::later, theta * theta, 2 * ratio * theta, 1)),
                  1 + 1e-12)
            << integrator.name << ' ' << theta << ' ' << ratio;
}

TEST(Integrators, GeneralizedAlphaDampsTheHighestFrequenciesByItsRho) {
  EXPECT_NEAR(spectral_radius(oscillator_step(generalized_alpha(), StepKind::later, 1e12, 0, 1)), .8, 2e-4);
  EXPECT_NEAR(spectral_radius(oscillator_step(generalized_alpha(), StepKind::later, 1e-6, 0, 1)), 1, 1e-9);
}

TEST(Integrators, CentralDifferenceRefusesAnUnstableStep) {
  EXPECT_NO_THROW(make_workspace<double>(oscillator(1.999 * 1.999, 0), central_difference(), 1));
  try {
    make_workspace<double>(oscillator(4.01, 0), central_difference(), 1);
    FAIL() << "an unstable step was taken";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("at most"), std::string::npos) << e.what();
  }
}

TEST(Integrators, CentralDifferenceIsTheThreeTermRecurrence) {
  const double lambda = 30, d = 1.5, dt = .05;
  const Model<double> model = oscillator(lambda, d);
  auto state = make_state<double>(model, central_difference(), number(1), number(0), number(0));
  auto workspace = make_workspace<double>(model, central_difference(), dt);
  std::vector<double> z = {1};
  for (int n = 0; n < 20; ++n) {
    step<double>(model, state, {number(0), number(0)}, dt, workspace);
    z.push_back(state.z()[0]);
  }
  for (std::size_t n = 1; n + 1 < z.size(); ++n) {
    const double residual =
        (z[n + 1] - 2 * z[n] + z[n - 1]) / (dt * dt) + d * (z[n + 1] - z[n - 1]) / (2 * dt) + lambda * z[n];
    EXPECT_NEAR(residual, 0, 1e-11) << n;
  }
}

// Of a body without stiffness all the work is kinetic energy, from the first step of a growing load on.
TEST(Integrators, CentralDifferenceBringsItsWorkIntoTheVelocity) {
  const auto model = make_model<double>({1, number(0), number(0), number(0)}, {});
  auto state = make_state<double>(model, central_difference(), number(0), number(0), number(0));
  auto workspace = make_workspace<double>(model, central_difference(), .1);
  double work = 0;
  for (int n = 0; n < 20; ++n) {
    work += step<double>(model, state, {number(3 * n), number(3 * (n + 1))}, .1, workspace).work;
    const double kinetic = state.velocity().squaredNorm() / 2;
    EXPECT_NEAR(work, kinetic, 1e-13 * kinetic) << n;
  }
}

TEST(Integrators, GoOnFromAStoredStateAsIfNeverStopped) {
  for (const auto& integrator : {exact(), newmark(), generalized_alpha(), bdf2()}) {
    const Model<double> model = oscillator(30, .3);
    auto state = make_state<double>(model, integrator, number(1), number(0), number(0));
    auto workspace = make_workspace<double>(model, integrator, .05);
    for (int n = 0; n < 10; ++n) step<double>(model, state, {number(0), number(0)}, .05, workspace);
    auto stored = state;
    auto other = make_workspace<double>(model, integrator, .05);
    for (int n = 0; n < 10; ++n) step<double>(model, state, {number(0), number(0)}, .05, workspace);
    for (int n = 0; n < 10; ++n) step<double>(model, stored, {number(0), number(0)}, .05, other);
    EXPECT_EQ(state.history, stored.history) << integrator.name;
  }
}

TEST(Integrators, NameTheStepThatAllModesAdmit) {
  const auto model = oscillators(Eigen::Vector3d(1e8, 4e12, 1e10), Eigen::Vector3d::Zero());
  double bound = 0;
  try {
    make_workspace<double>(model, central_difference(), 1);
    FAIL() << "an unstable step was taken";
  } catch (const InputError& error) {
    const std::string sentence = error.what(), before = "at most ";
    bound = std::stod(sentence.substr(sentence.find(before) + before.size()));
  }
  EXPECT_NEAR(bound, 2 / std::sqrt(4e12), 1e-5 * bound);
  EXPECT_NO_THROW(make_workspace<double>(model, central_difference(), bound));
}

TEST(Integrators, ChangeTheirStep) {
  // Ten steps of 0.01, then ten of 0.02, stay close to the truth: a restart of BDF2 included.
  const Model<double> model = oscillator(30, .3);
  auto truth = make_state<double>(model, exact(), number(1), number(0), number(0));
  auto exactly = make_workspace<double>(model, exact(), .3);
  step<double>(model, truth, {number(0), number(0)}, .3, exactly);
  for (const auto& integrator : {newmark(), generalized_alpha(), bdf2(), avf()}) {
    auto state = make_state<double>(model, integrator, number(1), number(0), number(0));
    auto workspace = make_workspace<double>(model, integrator, .01);
    for (int n = 0; n < 20; ++n) step<double>(model, state, {number(0), number(0)}, n < 10 ? .01 : .02, workspace);
    EXPECT_NEAR(state.z()[0], truth.z()[0], 2e-2) << integrator.name;
  }
}

TEST(Integrators, RejectAStepThatIsNotFinite) {
  const Model<double> model = oscillator(1, 0);
  auto state = make_state<double>(model, exact(), number(1), number(0), number(0));
  const Eigen::MatrixXd before = state.history;
  auto workspace = make_workspace<double>(model, exact(), .1);
  const Eigen::VectorXd nan = number(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(step<double>(model, state, {nan, nan}, .1, workspace).status, Status::not_finite);
  EXPECT_EQ(state.history, before);
}

TEST(Integrators, StepAModelWithNoModes) {
  const auto model = oscillators(Eigen::VectorXd(0), Eigen::VectorXd(0));
  const Eigen::VectorXd none(0);
  auto state = make_state<double>(model, exact(), none, none, none);
  auto workspace = make_workspace<double>(model, exact(), .1);
  EXPECT_EQ(step<double>(model, state, {none, none}, .1, workspace).status, Status::done);
}

}  // namespace
}  // namespace ritz::runtime
