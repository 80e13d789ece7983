// Where statics of the full model end: at limit points and bifurcations, named as such, or where Newton's method fails.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "ritz/algebra/check.hpp"
#include "ritz/base/error.hpp"
#include "ritz/stages/full_loads.hpp"
#include "ritz/stages/full_statics.hpp"
#include "support/full_runs.hpp"
#include "support/statics.hpp"

namespace ritz::test {
namespace {

constexpr double young = 1e5;
constexpr fem::Material soft_rubber = test::stvk(young, .3, 1000);

/// What statics that must fail say of it; `reached` is called after each step.
NumericalError complaint(
    FullRun& run, const algebra::Tall& force, int steps, const std::function<void()>& reached = [] {}) {
  try {
    stages::full_statics(
        run.model, {.steps = steps}, {0, run.zeros(), 0}, [&](double t) -> algebra::Tall { return t * force; },
        [&](const stages::StaticState&, const stages::StaticReport&) { reached(); });
  } catch (const NumericalError& error) {
    return error;
  }
  ADD_FAILURE() << "an equilibrium was found";
  return NumericalError("");
}

double load_fraction(const std::string& text) {
  const auto at = text.find("load fraction ");
  return at == text.npos ? -1 : std::stod(text.substr(at + 14));
}

/// A block in uniaxial strain, pressed with P: P = (λ + 2μ)/2 s (s² − 1) at a stretch s, the limit point at 1/√3.
struct Confined {
  double modulus;  ///< (λ + 2μ)/2
  FullRun run;

  Confined(double poisson, algebra::LinearSolver solver)
      : modulus(young / 2 * (1 - poisson) / (1 + poisson) / (1 - 2 * poisson)),
        run{problem(box("box:1,1,1/2,1,1/hex8"),
                    {fixed("xmin"), fixed("xmax", {0, 1, 1}), fixed("ymin", {0, 1, 0}), fixed("ymax", {0, 1, 0}),
                     fixed("zmin", {0, 0, 1}), fixed("zmax", {0, 0, 1})},
                    {test::stvk(young, poisson, 1000)}),
            solver} {}

  double limit() const { return modulus * 2 / (3 * std::sqrt(3)); }
  algebra::Tall pressed(double P) const {
    return run.free(stages::traction_force(run.p.mesh, *run.p.mesh.find("xmax"), {-P, 0, 0}));
  }
};

class LimitPoint : public testing::TestWithParam<algebra::LinearSolver> {};

// With so small a Poisson's ratio the block cannot warp before.
TEST_P(LimitPoint, IsNamedWhereItIs) {
  Confined block(.2, GetParam());
  EXPECT_NEAR(block.run.mean(block.run.statics(block.pressed(block.modulus * .75 * .4375), 4), "xmax").x(), -.25,
              1e-10);
  const std::string text = complaint(block.run, block.pressed(2 * block.limit()), 1).what();
  EXPECT_NEAR(load_fraction(text), .5, 1. / 1024 + 5e-4) << text;
  EXPECT_THAT(text, testing::HasSubstr("limit point"));
}

INSTANTIATE_TEST_SUITE_P(, LimitPoint, testing::Values(algebra::LinearSolver::direct, algebra::LinearSolver::iterative),
                         [](const auto& info) {
                           return std::string(info.param == algebra::LinearSolver::direct ? "direct" : "iterative");
                         });

// With this one it may: where μ s² + λ (s² − 1)/2 = 0 by the shortest waves, which the mesh has not.
TEST(FullStatics, NamesABifurcationBeforeTheLimitPoint) {
  Confined block(.3, algebra::LinearSolver::direct);
  EXPECT_NEAR(block.limit(), 25906.74, .005);
  EXPECT_NEAR(block.run.mean(block.run.statics(block.pressed(22085.336538461539), 4), "xmax").x(), -.25, 1e-10);
  const std::string text = complaint(block.run, block.pressed(2 * block.limit()), 1).what();
  EXPECT_THAT(text, testing::HasSubstr("bifurcation"));
  EXPECT_GE(load_fraction(text), block.modulus * std::sqrt(3. / 7) * (4. / 7) / (2 * block.limit()) - 1e-3) << text;
  EXPECT_LT(load_fraction(text), .4985) << text;
}

// A column that is pressed stays straight until it may buckle, at π² EI/(4 L²), EI being what its deflection says.
TEST(FullStatics, NamesABifurcation) {
  FullRun run{problem(box("box:1,.1,.1/10,1,1/hex8"), {fixed("xmin")}, {soft_rubber})};
  const algebra::Tall across = end_traction(run.p, "xmax", {0, 0, 1});
  const double EI = 1 / (3 * work(run.p, across, solve(run.p, across)));
  const double critical = std::pow(std::numbers::pi / 2, 2) * EI;
  const std::string text = complaint(run, end_traction(run.p, "xmax", {-2 * critical, 0, 0}), 1).what();
  EXPECT_THAT(text, testing::HasSubstr("bifurcation"));
  EXPECT_NEAR(load_fraction(text), .5, .02) << text;
}

// A Newton's method that may not iterate fails where nothing is critical: at rest, and bent by half the load.
TEST(FullStatics, NamesNoLimitPointWhereNewtonFailsAlone) {
  for (const bool bent : {false, true}) {
    FullRun run{problem(box("box:1,.15,.1/6,1,1/hex8"), {fixed("xmin")}, {soft_rubber})};
    const algebra::Tall force = end_traction(run.p, "xmax", {0, 2, 5});
    EXPECT_NO_THROW(run.statics(force, 2));
    const auto stop = [&] {
      algebra::check(
          SNESSetTolerances(run.model.newton.snes(), PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, 1, PETSC_DEFAULT));
    };
    if (!bent) stop();
    const NumericalError error = complaint(run, force, 2, stop);
    const std::string text = error.what();
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("limit point")));
    EXPECT_EQ(load_fraction(text), bent ? .5 : 0) << text;
    EXPECT_THAT(text, testing::HasSubstr("residual"));
    EXPECT_EQ(error.reason, Reason::load_steps_too_large);
  }
}

}  // namespace
}  // namespace ritz::test
