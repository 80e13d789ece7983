// Whole runs of the sample model with hardening springs; the right mass alone obeys z'' + 9 z + 4 z³ = f.
#include <gmock/gmock.h>

#include <cmath>

#include "ritz/base/error.hpp"
#include "support/nonlinear_sample_model.hpp"
#include "tools/run_support.hpp"

namespace ritz::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string probe = "[[probe]]\nname = 'p'\nset = 'tip'\n";
/// u_z of the tip is z₂/√2 and its total force along z is √2 f.
const double root2 = std::sqrt(2.0);

std::string load(double total) {
  std::ostringstream text;
  text.precision(17);
  text << "[[load]]\nset = 'tip'\ntotal = [0, 0, " << total << "]\n";
  return text.str();
}

/// The Duffing oscillator under a constant force from rest, by many small steps of a Runge-Kutta method.
double duffing_at(double t, double force) {
  const int steps = 20000;
  const double h = t / steps;
  double z = 0, v = 0;
  const auto a = [&](double x) { return force - 9 * x - 4 * x * x * x; };
  for (int n = 0; n < steps; ++n) {
    const double v1 = v, a1 = a(z), v2 = v + h / 2 * a1, a2 = a(z + h / 2 * v1), v3 = v + h / 2 * a2;
    const double a3 = a(z + h / 2 * v2), v4 = v + h * a3, a4 = a(z + h * v3);
    z += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return z;
}

TEST(RunNonlinear, FollowsTheOscillatorWithEveryIntegrator) {
  const double expected = duffing_at(1, 20) / root2;
  for (const std::string name :
       {"", "implicit-euler", "newmark", "generalized-alpha", "bdf2", "central-difference", "avf", "linearly-implicit"})
    for (const auto precision : {world::Precision::float64, world::Precision::float32}) {
      const test::RunFolder folder;
      const std::string choice = name.empty() ? "" : "integrator = '" + name + "'\n";
      auto options = folder.prepare("[time]\nstep = 1e-3\nend = 1\n" + choice + load(20 * root2) + probe,
                                    test::nonlinear_sample_model());
      options.precision = precision;
      options.voice = Voice::verbose;
      const auto said = test::run(options);
      EXPECT_THAT(said, HasSubstr("1000 steps of 2 coordinates"));
      EXPECT_THAT(said, HasSubstr("Newton iterations, 0 attempts did not converge"));
      EXPECT_THAT(said, Not(HasSubstr("warning")));
      EXPECT_NEAR(test::read_csv(folder / "probes.csv").rows.back()[3], expected,
                  name == "implicit-euler"                 ? 2e-2
                  : precision == world::Precision::float32 ? 2e-3
                                                           : 2e-4)
          << name;
    }
}

TEST(RunNonlinear, StaticsAreTheRootOfTheCubic) {
  const test::RunFolder folder;
  auto options = folder.prepare("[static]\nsteps = 4\n" + load(26 * root2) + probe, test::nonlinear_sample_model());
  options.timing = folder / "timing.csv";
  EXPECT_THAT(test::run(options), HasSubstr("4 load steps of 2 coordinates"));
  EXPECT_EQ(test::read_csv(folder / "timing.csv").rows.size(), 4u) << "the body at rest is no step";
  const auto rows = test::read_csv(folder / "probes.csv").rows;
  ASSERT_EQ(rows.size(), 5u);
  for (const auto& row : rows) {
    const double z = root2 * row[3];
    EXPECT_NEAR(9 * z + 4 * z * z * z, 26 * row[0], 1e-11);
  }
}

TEST(RunNonlinear, TheTimingAddsUpToWhatIsSaid) {
  const test::RunFolder folder;
  auto options = folder.prepare("[time]\nstep = 0.1\nend = 2\n" + load(20 * root2), test::nonlinear_sample_model());
  options.timing = folder / "timing.csv";
  options.voice = Voice::verbose;
  const auto said = test::run(options);
  const auto rows = test::read_csv(folder / "timing.csv").rows;
  ASSERT_EQ(rows.size(), 20u);
  int iterations = 0;
  for (const auto& row : rows) iterations += static_cast<int>(row[2]);
  EXPECT_GE(iterations, 20);
  EXPECT_THAT(said, HasSubstr(" " + std::to_string(iterations) + " Newton iterations"));
}

TEST(RunNonlinear, ALimitPointIsNamed) {
  const test::RunFolder folder;
  auto model = test::nonlinear_sample_model();
  model.bodies[0].polynomial->quartic[4] *= -1;  // softening: f = 9 z - 4 z³ is at most 3√3
  const auto options = folder.prepare("[static]\nsteps = 10\n" + load(2 * 3 * std::sqrt(3) * root2), model);
  try {
    test::run(options);
    ADD_FAILURE() << "went past the limit point";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), HasSubstr("load fraction 0.5 "));
    EXPECT_THAT(error.what(), HasSubstr("a limit point"));
  }
  EXPECT_TRUE(folder.outputs().empty());
}

TEST(RunNonlinear, AReductionWithoutAPolynomialIsLinear) {
  const test::RunFolder folder;
  auto model = test::nonlinear_sample_model();
  model.bodies[0].polynomial.reset();
  model.bodies[0].modes.reset();
  test::run(folder.prepare("[time]\nstep = 0.1\nend = 5\n" + load(18) + probe, model));
  for (const auto& row : test::read_csv(folder / "probes.csv").rows)
    EXPECT_NEAR(row[3], 1 - std::cos(3 * row[0]), 1e-13);
}

TEST(RunNonlinear, WarnsOfEnergyFromNowhere) {
  const std::string scene =
      "[time]\nstep = 0.2\nend = 80\nintegrator = 'newmark'\n[[load]]\nset = 'tip'\n"
      "total = [0, 0, 424]\ntable = [[0, 1], [0.2, 1], [0.4, 0]]\n";
  const test::RunFolder folder;
  EXPECT_THAT(test::run(folder.prepare(scene, test::nonlinear_sample_model())),
              HasSubstr("gained energy without work"));
  auto calm = scene;
  calm.replace(calm.find("newmark"), 7, "avf");
  EXPECT_THAT(test::run(folder.prepare(calm, test::nonlinear_sample_model())), Not(HasSubstr("warning")));
}

/// Where damping takes the energy, its balance does not tell.
TEST(RunNonlinear, WarnsOfStepsThatAreTooLong) {
  const test::RunFolder folder;
  for (const auto& [step, warned] : {std::pair("0.5", true), {"0.01", false}}) {
    const auto scene = "[time]\nstep = " + std::string(step) +
                       "\nend = 10\nintegrator = 'linearly-implicit'\n[damping]\nalpha = 1\n" + load(20);
    const auto said = test::run(folder.prepare(scene, test::nonlinear_sample_model()));
    EXPECT_EQ(said.find("the steps are too long for this motion") != said.npos, warned) << said;
    EXPECT_THAT(said, Not(HasSubstr("gained energy")));
  }
}

/// J gained and lost, relative to what there was, as ritz-run prints them.
std::pair<double, double> balance(const std::string& printed) {
  const auto number_after = [&](const std::string& words, std::size_t from) {
    const auto at = printed.find(words, from);
    return at == printed.npos ? std::nan("") : std::stod(printed.substr(at + words.size()));
  };
  const auto line = printed.find("energy balance: ");
  const double scale = number_after("damping), of ", line);
  return {number_after("at most ", line) / scale, number_after("from nowhere and ", line) / scale};
}

TEST(RunNonlinear, PrintsTheBalanceOfTheEnergy) {
  const test::RunFolder folder;
  const std::string scene = "[time]\nstep = 0.1\nend = 1\n" + load(20);
  for (const auto* damping : {"", "[damping]\nalpha = 0.1\n", "[damping]\nalpha = 0.3\nbeta = 0.02\n"}) {
    const auto [gained, lost] = balance(test::run(folder.prepare(scene + damping, test::nonlinear_sample_model())));
    EXPECT_LE(gained, 1e-9) << damping;
    EXPECT_LE(lost, 1e-9) << damping;
  }
  const auto euler = std::string(scene).replace(scene.find("end"), 0, "integrator = 'implicit-euler'\n");
  EXPECT_GT(balance(test::run(folder.prepare(euler, test::nonlinear_sample_model()))).second, 1e-3);
}

void expect_refusal(const RunOptions& options, const std::string& complaint) {
  try {
    test::run(options);
    ADD_FAILURE() << "accepted, should say " << complaint;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(complaint));
  }
}

TEST(RunNonlinear, RefusesWhatIsForLinearModels) {
  const test::RunFolder folder;
  auto options = folder.prepare("[time]\nstep = 0.1\nend = 1\nintegrator = 'exact'\n", test::nonlinear_sample_model());
  expect_refusal(options, "choose avf, implicit-euler");
  options.scene.clear();
  options.animate_mode = 1;
  expect_refusal(options, "columns are not modes");
  auto linear = folder.prepare("[time]\nstep = 0.1\nend = 1\n");
  linear.precision = world::Precision::float32;
  expect_refusal(linear, "--single is for nonlinear forces");
  expect_refusal(
      folder.prepare("[time]\nstep = 1\nend = 3\nintegrator = 'central-difference'\n", test::nonlinear_sample_model()),
      "unstable");
}

TEST(RunNonlinear, WarnsOnceBeyondTheTrainingOfACubature) {
  const test::RunFolder folder;
  const auto said = [&](const std::string& analysis, double force) {
    return test::run(folder.prepare(analysis + load(force * root2), test::cubature_sample_model()));
  };
  const std::string time = "[time]\nstep = 1e-2\nend = 1\n", statics = "[static]\nsteps = 4\n";
  EXPECT_THAT(said(time, 10), Not(HasSubstr("trained")));
  const auto warned = said(time, 60);
  EXPECT_THAT(warned, AllOf(HasSubstr("from t = 0."), HasSubstr("beyond the poses that its cubature was trained on")));
  EXPECT_EQ(warned.find("trained"), warned.rfind("trained"));
  EXPECT_THAT(said(statics, 90), HasSubstr("from the load fraction 0.75 on"));
}

TEST(RunNonlinear, ReadsACubatureForItsForcesAlone) {
  const test::RunFolder folder;
  auto with = test::cubature_sample_model();
  const auto tip = [&](const model::Model& model, tools::Forces forces) {
    auto options = folder.prepare("[static]\nsteps = 1\n" + load(30 * root2) + probe, model);
    options.forces = forces;
    test::run(options);
    return test::read_csv(folder / "probes.csv").rows.back()[3];
  };
  const double stretched = tip(with, Forces::stored), linear = tip(with, Forces::linear);
  with.bodies[0].cubature.reset();
  EXPECT_NE(tip(with, Forces::stored), stretched);
  EXPECT_EQ(tip(with, Forces::linear), linear);
}

}  // namespace
}  // namespace ritz::tools
