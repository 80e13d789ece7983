// How a motion starts, what its probes measure, and that it goes on as if it had not stopped.
#include <gmock/gmock.h>

#include <cmath>

#include "ritz/base/error.hpp"
#include "support/nonlinear_sample_model.hpp"
#include "tools/run_support.hpp"

namespace ritz::tools {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Gt;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using testing::ThrowsMessage;

const std::string all_of_the_tip =
    "[[probe]]\nname = 'p'\nset = 'tip'\nquantity = ['displacement', 'velocity', 'acceleration']\n";
const std::vector<std::string> nonlinear_integrators = {
    "avf", "newmark", "generalized-alpha", "linearly-implicit", "bdf2", "implicit-euler", "central-difference"};
const double root_of_2 = std::sqrt(2.0);

std::string time_of(double step, double end, const std::string& integrator) {
  std::ostringstream text;
  text.precision(17);
  text << "[time]\nstep = " << step << "\nend = " << end << "\nintegrator = '" << integrator << "'\n";
  return text.str();
}

TEST(RunStart, AnInitialShapeSwingsAsACosine) {
  const test::RunFolder folder;
  test::run(folder.prepare(time_of(.1, 5, "exact") + "[initial]\nz = [0, 1.4142135623730951]\n" + all_of_the_tip));
  const auto csv = test::read_csv(folder / "probes.csv");
  EXPECT_EQ(csv.header, "t,p_ux,p_uy,p_uz,p_vx,p_vy,p_vz,p_ax,p_ay,p_az");
  ASSERT_THAT(csv.rows, SizeIs(51));
  const auto zdot = test::read_numbers(folder / "motion.h5", "/zdot");
  ASSERT_THAT(zdot.shape, ElementsAre(51, 2));
  for (std::size_t n = 0; n < csv.rows.size(); ++n) {
    const auto& row = csv.rows[n];
    const double t = .1 * static_cast<double>(n);  // ω = 3
    EXPECT_NEAR(row[3], std::cos(3 * t), 1e-12);
    EXPECT_NEAR(row[6], -3 * std::sin(3 * t), 1e-12);
    EXPECT_NEAR(row[9], -9 * std::cos(3 * t), 1e-11);
    EXPECT_NEAR(zdot.values[2 * n + 1], root_of_2 * row[6], 1e-13);
    EXPECT_EQ(row[4], 0);
  }
}

TEST(RunStart, AnInitialVelocitySwingsAsASine) {
  for (const std::string integrator : {"exact", "newmark", "generalized-alpha", "bdf2", "avf", "central-difference"}) {
    const test::RunFolder folder;
    test::run(folder.prepare(time_of(1e-3, 1, integrator) + "[initial]\nvelocity = [0, 3]\n" + all_of_the_tip));
    const auto last = test::read_csv(folder / "probes.csv").rows.back();
    EXPECT_NEAR(root_of_2 * last[3], std::sin(3.), 1e-5) << integrator;
    EXPECT_NEAR(root_of_2 * last[6], 3 * std::cos(3.), 4e-5) << integrator;
  }
}

/// What an accelerometer shows is in balance with the forces, whatever the integrator keeps.
TEST(RunStart, AccelerationsObeyTheEquationOfMotion) {
  for (const auto& integrator : nonlinear_integrators)
    for (const bool nonlinear : {false, true}) {
      const test::RunFolder folder;
      test::run(folder.prepare(time_of(.01, 1, integrator) + "[damping]\nalpha = 0.5\n[initial]\nz = [0, 0.3]\n" +
                                   "[[load]]\nset = 'tip'\ntotal = [0, 0, 20]\ntable = [[0, 1], [1, -2]]\n" +
                                   all_of_the_tip,
                               nonlinear ? test::nonlinear_sample_model() : test::sample_model()));
      for (const auto& row : test::read_csv(folder / "probes.csv").rows) {
        const double z = root_of_2 * row[3], force = 20 / root_of_2 * (1 - 3 * row[0]);
        EXPECT_NEAR(root_of_2 * row[9], force - .5 * root_of_2 * row[6] - 9 * z - (nonlinear ? 4 * z * z * z : 0),
                    1e-10)
            << integrator;
      }
    }
}

TEST(RunStart, AStaticStartStaysAtRest) {
  for (const auto& integrator : nonlinear_integrators)
    for (const bool nonlinear : {false, true}) {
      const test::RunFolder folder;
      test::run(folder.prepare("gravity = [0, 0, -9]\n" + time_of(.1, 3, integrator) + "[initial]\nstatic = true\n" +
                                   "[[load]]\nset = 'tip'\ntotal = [0, 0, 100]\ntable = [[0, 1]]\n" + all_of_the_tip,
                               nonlinear ? test::nonlinear_sample_model() : test::sample_model()));
      const auto rows = test::read_csv(folder / "probes.csv").rows;
      EXPECT_GT(std::abs(rows.front()[3]), 1);
      for (const auto& row : rows) {
        EXPECT_NEAR(row[3], rows.front()[3], 1e-12) << integrator;
        EXPECT_NEAR(row[6], 0, 1e-11) << integrator;
        EXPECT_NEAR(row[9], 0, 1e-9) << integrator;
      }
    }
}

TEST(RunStart, AStateOfAMotionBeginsAnother) {
  const test::RunFolder folder;
  const std::string swing = time_of(.1, 2, "exact");
  auto first = folder.prepare(swing + "[initial]\nz = [1, 0]\nvelocity = [0, 2]\n");
  first.output = folder / "first.h5";
  test::run(first);
  for (const auto& [key, index] : {std::pair<std::string, std::size_t>{"time = 0.7\n", 7}, {"", 20}}) {
    test::run(folder.prepare(swing + "[initial]\nmotion = 'first.h5'\n" + key));
    const auto z = test::read_numbers(folder / "motion.h5", "/z").values;
    const auto before = test::read_numbers(folder / "first.h5", "/z").values;
    EXPECT_EQ(z[0], before[2 * index]);
    EXPECT_EQ(z[1], before[2 * index + 1]);
    for (std::size_t n = 0; index + n < 21; ++n)
      for (std::size_t i : {0u, 1u}) EXPECT_NEAR(z[2 * n + i], before[2 * (index + n) + i], 1e-13);
  }
}

TEST(RunStart, OfAStaticMotionLetsTheBodyGo) {
  const test::RunFolder folder;
  auto bent = folder.prepare("[static]\nsteps = 2\n[[load]]\nset = 'tip'\ntotal = [0, 0, 18]\n");
  bent.output = folder / "bent.h5";
  test::run(bent);
  test::run(folder.prepare(time_of(.1, 2, "exact") + "[initial]\nmotion = 'bent.h5'\n" + all_of_the_tip));
  for (const auto& row : test::read_csv(folder / "probes.csv").rows) EXPECT_NEAR(row[3], std::cos(3 * row[0]), 1e-13);
}

/// What a run to the end and one that stopped halfway have in common, to the last bit.
void expect_to_go_on(const std::string& scene, const model::Model& model, double step, double end,
                     const std::string& integrator, world::Precision precision, const std::string& case_name) {
  const test::RunFolder folder;
  const auto run_to = [&](double when, const std::string& output, const std::string& restart) {
    auto options = folder.prepare(time_of(step, when, integrator) + scene, model);
    options.output = folder / output;
    if (!restart.empty()) options.restart = folder / restart;
    options.precision = precision;
    options.frames = 0;
    test::run(options);
  };
  run_to(end, "whole.h5", "");
  run_to(end / 4, "a.h5", "");
  run_to(end / 2, "b.h5", "a.h5");
  run_to(end, "b.h5", "b.h5");  // takes the place of what it goes on from
  for (const auto* name : {"/times", "/z", "/zdot"}) {
    const auto whole = test::read_numbers(folder / "whole.h5", name).values;
    const auto rest = test::read_numbers(folder / "b.h5", name).values;
    ASSERT_THAT(rest.size(), Gt(1u));
    EXPECT_EQ(rest, std::vector(whole.end() - static_cast<std::ptrdiff_t>(rest.size()), whole.end()))
        << case_name << name;
  }
  EXPECT_EQ(test::read_numbers(folder / "b.h5", "/state/history").values,
            test::read_numbers(folder / "whole.h5", "/state/history").values)
      << case_name;
  EXPECT_EQ(test::read_attributes(folder / "b.h5", "/state"), test::read_attributes(folder / "whole.h5", "/state"))
      << case_name;
  const auto whole = test::read_csv(folder / "whole.probes.csv").rows,
             rest = test::read_csv(folder / "b.probes.csv").rows;
  EXPECT_EQ(rest, std::vector(whole.end() - std::ssize(rest), whole.end())) << case_name;
}

const std::string pushed =
    "[damping]\nalpha = 0.1\nbeta = 1e-3\n[[load]]\nset = 'tip'\ntotal = [0, 0, 300]\n"
    "table = [[0, 1], [1, -1], [3, 0.5]]\n" +
    all_of_the_tip;

TEST(RunRestart, RepeatsAMotionToTheLastBit) {
  auto linear = nonlinear_integrators;
  linear.emplace_back("exact");
  for (const auto& integrator : linear)
    expect_to_go_on(pushed, test::sample_model(), .02, 4, integrator, world::Precision::float64, integrator);
  for (const auto& integrator : nonlinear_integrators)
    expect_to_go_on(pushed, test::nonlinear_sample_model(), .02, 4, integrator, world::Precision::float64,
                    integrator + ", nonlinear");
  for (const auto* integrator : {"avf", "newmark", "bdf2"})
    expect_to_go_on(pushed, test::nonlinear_sample_model(), .02, 4, integrator, world::Precision::float32,
                    "in single precision");
}

/// Between two wells Newton's method goes astray now and then.
TEST(RunRestart, RepeatsStepsThatWereHalvedAndAStartOfItsOwn) {
  auto model = test::nonlinear_sample_model();
  model.bodies[0].polynomial->cubic[3] = -184;  // z₂'' + 9 z₂ − 92 z₂² + 4 z₂³ = f
  const std::string hard =
      "[initial]\nz = [0, -0.5]\nvelocity = [0, 3]\n[[load]]\nset = 'tip'\ntotal = [0, 0, 2.8284271247461903]\n"
      "table = [[0, 0], [1, 1], [2, -1], [3, 1], [4, -1]]\n" +
      all_of_the_tip;
  for (const auto* integrator : {"avf", "newmark", "linearly-implicit", "bdf2", "implicit-euler"}) {
    const test::RunFolder folder;
    EXPECT_THAT(test::run(folder.prepare(time_of(.5, 4, integrator) + hard, model)),
                HasSubstr("did not converge and went on in halves"))
        << integrator;
    expect_to_go_on(hard, model, .5, 4, integrator, world::Precision::float64, integrator);
  }
}

TEST(RunRestart, OfSeveralBodies) {
  const test::RunFolder folder;
  const auto scene = [](double end) {
    return time_of(.1, end, "newmark") +
           "[[body]]\nname = 'a'\ninitial = { z = [0, 1] }\n[[body]]\nname = 'b'\n[[load]]\nbody = 'b'\nset = 'tip'\n"
           "total = [0, 0, 3]\n[initial]\nvelocity = [1, 1]\n";
  };
  auto options = folder.prepare(scene(2));
  test::run(options);
  EXPECT_THAT(test::read_numbers(folder / "motion.a.h5", "/zdot").values[1], 0);
  EXPECT_THAT(test::read_numbers(folder / "motion.b.h5", "/zdot").values[1], 1);
  options = folder.prepare(scene(1));
  options.output = folder / "half.h5";
  test::run(options);
  options = folder.prepare(scene(2));
  options.restart = folder / "half.h5";
  options.output = folder / "rest.h5";
  test::run(options);
  for (const std::string body : {"a", "b"})
    EXPECT_EQ(test::read_numbers(folder / ("rest." + body + ".h5"), "/state/history").values,
              test::read_numbers(folder / ("motion." + body + ".h5"), "/state/history").values);
}

void expect_start_refusal(const test::RunFolder& folder, const RunOptions& options, const std::string& complaint) {
  const auto before = folder.outputs();
  EXPECT_THAT([&] { test::run(options); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(complaint), Not(HasSubstr("\n")))));
  EXPECT_EQ(folder.outputs(), before) << complaint;
}

TEST(RunRestart, RefusesWhatItCannotGoOnFrom) {
  const test::RunFolder folder;
  const std::string load = "[[load]]\nset = 'tip'\ntotal = [0, 0, 3]\n";
  auto half = folder.prepare(time_of(.1, 1, "newmark") + load);
  half.output = folder / "half.h5";
  test::run(half);
  const auto refused = [&](const std::string& scene, const std::string& complaint,
                           const model::Model& model = test::sample_model()) {
    auto options = folder.prepare(scene, model);
    options.restart = folder / "half.h5";
    expect_start_refusal(folder, options, complaint);
  };
  refused(time_of(.1, 1, "newmark") + load, "nothing is left to do");
  for (const auto& other : {time_of(.1, 2, "avf") + load, time_of(.05, 2, "newmark") + load, time_of(.1, 2, "newmark"),
                            time_of(.1, 2, "newmark") + load + "[damping]\nalpha = 1\n",
                            time_of(.1, 2, "newmark") + load + "[initial]\nz = [0, 1]\n",
                            time_of(.1, 2, "newmark") + "[[load]]\nset = 'tip'\ntotal = [0, 0, 3.0000000000000004]\n"})
    refused(other, "under another scene");
  auto model = test::sample_model();
  model.bodies[0].basis.U.col(0) *= -1;  // the same body, and other coordinates
  refused(time_of(.1, 2, "newmark") + load, "the motion of another model", model);
  refused("[static]\nsteps = 2\n" + load, "--restart goes on in time");
  auto options = folder.prepare(time_of(.1, 2, "newmark") + load);
  options.restart = folder / "scene.toml";
  expect_start_refusal(folder, options, "not an HDF5 file");
  options.restart = options.model;
  expect_start_refusal(folder, options, "not a motion of a reduced model");
  options.restart = folder / "none.h5";
  expect_start_refusal(folder, options, "none.h5");
  auto bent = folder.prepare("[static]\nsteps = 2\n" + load);
  bent.output = folder / "bent.h5";
  test::run(bent);
  options = folder.prepare(time_of(.1, 2, "newmark") + load);
  options.restart = folder / "bent.h5";
  expect_start_refusal(folder, options, "no last state");
}

TEST(RunStart, RefusesAStartThatDoesNotFit) {
  const test::RunFolder folder;
  auto first = folder.prepare(time_of(.1, 1, "exact"));
  first.output = folder / "first.h5";
  test::run(first);
  const auto refused = [&](const std::string& initial, const std::string& complaint,
                           const model::Model& model = test::sample_model()) {
    expect_start_refusal(folder, folder.prepare(time_of(.1, 1, "avf") + "[initial]\n" + initial, model), complaint);
  };
  refused("z = [1]", "1 numbers of z, and the model has 2");
  refused("velocity = [1, 2, 3]", "3 numbers of its velocity");
  refused("motion = 'first.h5'\ntime = 0.55", "no state at t = 0.55 s; the nearest is at 0.");
  refused("motion = 'first.h5'\ntime = 1.1", "the last at 1 s");
  refused("motion = 'first.h5'", "of another model", test::nonlinear_sample_model());
  refused("motion = 'first.h5'\nmodel = 'model.h5'", "leave it out");
  refused("motion = 'none.h5'", "none.h5");
  auto free = test::sample_model();
  free.bodies[0].modes->kinds[0] = model::ModeKind::rigid;
  free.bodies[0].modes->eigenvalues[0] = 0;
  refused("static = true\n[[load]]\nvertex = 10\ntotal = [0, 0, 1]", "the body is free", free);
  auto options = folder.prepare(time_of(.1, 1, "exact") + "[initial]\nmotion = 'first.h5'");
  options.output = folder / "first.h5";
  expect_start_refusal(folder, options, "would overwrite an input");
  options = folder.prepare("");
  options.scene.clear();
  options.animate_mode = 1;
  options.output = folder / "mode.h5";
  test::run(options);
  refused("motion = 'mode.h5'", "it shows a mode");
}

}  // namespace
}  // namespace ritz::tools
