// Motions of the full model: energy, order of accuracy, a linear limit, rejected steps, restart.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/matrix.hpp"
#include "ritz/base/error.hpp"
#include "ritz/stages/full_loads.hpp"
#include "support/full_runs.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;
using stages::DynamicOptions, stages::FullIntegrator;

FullRun beam(const std::string& cells = "hex8", const fem::Materials& materials = {soft}) {
  return {problem(box("box:1,.15,.1/6,1,1/" + cells), {fixed("xmin")}, materials)};
}

/// A law whose force is a cubic, and one whose force is no polynomial.
const std::vector<fem::Materials> laws = {{soft}, neo_hookean({soft})};

Tall end_force(const FullRun& run, const Eigen::Vector3d& newton) {
  return run.free(stages::shared_force(run.p.mesh, *run.p.mesh.find("xmax"), newton));
}

stages::LoadAt constant(const Tall& F) {
  return [F](double) { return F; };
}

class Cells : public testing::TestWithParam<const char*> {};

// Pulled sideways and released: nothing is gained or lost in 200 steps.
TEST_P(Cells, AvfKeepsTheEnergy) {
  for (const auto& materials : laws) {
    FullRun run = beam(GetParam(), materials);
    auto start = run.rest();
    start.u = run.statics(end_force(run, {0, 4, 10}), 2);
    stages::DynamicReport report;
    const auto last =
        run.motion({.integrator = FullIntegrator::avf, .dt = .02}, start, 200, constant(run.zeros()), &report);
    EXPECT_EQ(report.rejected, 0);
    EXPECT_GT(last.energies.start, .1);
    EXPECT_LE(std::max(report.gained, report.lost), 1e-9 * last.energies.start) << fem::name(materials[0].law);
  }
}

TEST_P(Cells, HaveTheirOrdersOfAccuracy) {
  for (const auto& materials : laws) {
    FullRun run = beam(GetParam(), materials);
    const Tall F = end_force(run, {0, 3, 8});
    const auto load = [&](double t) -> Tall { return std::pow(std::sin(3 * t), 2) * F; };
    const auto at = [&](FullIntegrator how, int n) {
      return run.motion({.integrator = how, .dt = .4 / n}, run.rest(), n, load).u;
    };
    const Tall reference = at(FullIntegrator::newmark, 160);
    const auto error = [&](FullIntegrator how, int n) { return stages::norm(run.model, at(how, n) - reference); };
    for (const auto& [integrator, order] :
         {std::pair{FullIntegrator::newmark, 2.}, {FullIntegrator::avf, 2.}, {FullIntegrator::implicit_euler, 1.}})
      EXPECT_NEAR(std::log2(error(integrator, 20) / error(integrator, 40)), order, .2) << fem::name(materials[0].law);
  }
}

INSTANTIATE_TEST_SUITE_P(FullDynamics, Cells, testing::Values("tet4", "tet10", "hex8", "hex20", "wedge6", "wedge15"),
                         [](const auto& info) { return std::string(info.param); });

// With load and damping the balance holds as well: E − E₀ = W − Q.
TEST(FullDynamics, AvfBalancesWorkAndDamping) {
  FullRun run = beam();
  const Tall F = end_force(run, {0, 2, 8});
  stages::DynamicReport report;
  const auto load = [&](double t) -> Tall { return std::sin(4 * t) * F; };
  const auto last = run.motion({.integrator = FullIntegrator::avf, .alpha = .3, .beta = .002, .dt = .02}, run.rest(),
                               100, load, &report);
  EXPECT_GT(last.energies.dissipated, .1);
  EXPECT_LE(std::max(report.gained, report.lost), 1e-9 * (last.energies.dissipated + last.energies.kinetic));
}

// At small amplitudes a mode swings as Newmark's recurrence for an oscillator says: u(t) = cos(θ t/Δt), with
// tan(θ/2) = ω Δt/2.
TEST(FullDynamics, SwingsAModeAsTheRecurrenceSays) {
  FullRun run = beam("tet10");
  const auto result = modes(run.p, 1);
  const double dt = .02, omega = std::sqrt(result.modes.eigenvalues[0]), theta = 2 * std::atan(omega * dt / 2);
  const Tall psi = result.vectors.col(0);
  for (const auto integrator : {FullIntegrator::newmark, FullIntegrator::avf}) {
    auto start = run.rest();
    start.u = 1e-9 * psi;
    const auto last = run.motion({.integrator = integrator, .dt = dt}, start, 50, constant(run.zeros()));
    EXPECT_LE(stages::norm(run.model, last.u - std::cos(50 * theta) * start.u),
              1e-7 * stages::norm(run.model, start.u));
  }
}

/// A beam that a blow has set moving, and a Newton's method that may only iterate so often.
struct Blow {
  FullRun run = beam();
  stages::DynamicState start = run.rest();

  explicit Blow(int most_iterations) {
    const Tall shape = algebra::solve_mass(run.p.matrices.mass, end_force(run, {-4, 3, 5}));
    start.v = 6 / algebra::column_norms(run.p.mesh.comm, shape)[0] * shape;
    algebra::check(SNESSetTolerances(run.model.newton.snes(), PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT,
                                     most_iterations, PETSC_DEFAULT));
  }
};

// A step that is too long for the iterations there are is halved, and counted; energy is kept all the same.
TEST(FullDynamics, HalvesAStepThatDoesNotConverge) {
  Blow blow(4);
  stages::DynamicReport report;
  const auto last = blow.run.motion({.integrator = FullIntegrator::avf, .dt = .2}, blow.start, 3,
                                    constant(blow.run.zeros()), &report);
  EXPECT_GT(report.rejected, 0);
  EXPECT_NEAR(last.t, .6, 1e-15);
  EXPECT_LE(std::max(report.gained, report.lost), 1e-9 * last.energies.start);
}

TEST(FullDynamics, NamesTheStepThatCannotBeTaken) {
  Blow blow(1);
  try {
    blow.run.motion({.integrator = FullIntegrator::newmark, .dt = .2}, blow.start, 3, constant(blow.run.zeros()));
    ADD_FAILURE() << "took a step in one iteration";
  } catch (const NumericalError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("t = 0 s"), text.npos) << text;
    EXPECT_NE(text.find("residual"), text.npos) << text;
  }
}

// Whatever the load: a motion that is finite, or an error; here for loads up to where numbers end.
TEST(FullDynamics, NeverGoesOnWithoutNumbers) {
  FullRun run = beam();
  for (const double size : {1e3, 1e6, 1e9, 1e100, 1e200}) {
    const Tall F = end_force(run, size * Eigen::Vector3d(1, 2, -1));
    stages::DynamicState last = run.rest();
    try {
      last = run.motion({.dt = .05}, run.rest(), 3, constant(F));
    } catch (const NumericalError& error) {
      EXPECT_NE(std::string(error.what()).find("did not converge"), std::string::npos) << error.what();
    }
    EXPECT_TRUE(last.u.allFinite()) << size;
  }
}

TEST(FullDynamics, GoesOnFromAState) {
  FullRun run = beam();
  const Tall F = end_force(run, {0, 3, 8});
  const auto load = [&](double t) -> Tall { return std::sin(3 * t) * F; };
  for (const auto integrator : {FullIntegrator::newmark, FullIntegrator::avf, FullIntegrator::implicit_euler}) {
    const DynamicOptions options{.integrator = integrator, .alpha = .1, .dt = .01};
    const auto whole = run.motion(options, run.rest(), 20, load);
    stages::DynamicState state = run.motion(options, run.rest(), 12, load);
    stages::full_dynamics(run.model, options, state, 8, load,
                          [&](const stages::DynamicState& s, const stages::DynamicReport&) { state = s; });
    EXPECT_LE(stages::norm(run.model, state.u - whole.u), 1e-12 * stages::norm(run.model, whole.u));
    EXPECT_NEAR(state.energies.drift(), whole.energies.drift(), 1e-12);
  }
}

}  // namespace
}  // namespace ritz::test
