// Whole runs on the sample model (λ = 4 and 9; u_z(right) = z₂/√2) against closed forms.
#include <gmock/gmock.h>

#include <cmath>

#include "ritz/base/error.hpp"
#include "tools/run_support.hpp"

namespace ritz::tools {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

TEST(Run, AStepLoadOnTheTip) {
  const test::RunFolder folder;
  auto options = folder.prepare(R"(
[time]
step = 0.1
end = 5
[[load]]
set = "tip"
total = [0, 0, 18]
[[probe]]
name = "tip"
set = "tip"
[[probe]]
name = "right"
vertex = 20
)");
  options.frame_numbers = format::Stored::float64;
  const std::string said = test::run(options);
  EXPECT_THAT(said, HasSubstr("50 steps of 2 coordinates"));
  EXPECT_THAT(said, HasSubstr("51 frames"));
  EXPECT_THAT(folder.outputs(), ElementsAre("motion.h5", "motion.xdmf", "probes.csv"));

  const auto csv = test::read_csv(folder / "probes.csv");
  EXPECT_EQ(csv.header, "t,tip_ux,tip_uy,tip_uz,right_ux,right_uy,right_uz");
  const auto z = test::read_numbers(folder / "motion.h5", "/z");
  const auto u = test::read_numbers(folder / "motion.h5", "/displacement");
  ASSERT_EQ(csv.rows.size(), 51u);
  ASSERT_THAT(z.shape, ElementsAre(51, 2));
  ASSERT_THAT(u.shape, ElementsAre(51, 4, 3));
  for (std::size_t n = 0; n < csv.rows.size(); ++n) {
    const double t = .1 * static_cast<double>(n);
    const double tip = 18 / (2 * 9.) * (1 - std::cos(3 * t));  // 2 kg on a spring of 18 N/m
    EXPECT_NEAR(csv.rows[n][0], t, 1e-14);
    EXPECT_NEAR(csv.rows[n][3], tip, 1e-13);
    EXPECT_NEAR(csv.rows[n][6], tip, 1e-13);
    EXPECT_NEAR(z.values[2 * n + 1], tip * std::sqrt(2), 1e-13);
    EXPECT_NEAR(u.values[12 * n + 5], tip, 1e-13);
    EXPECT_EQ(z.values[2 * n], 0);
  }
}

TEST(Run, EveryIntegratorNearsTheExactMotion) {
  for (const std::string name : {"exact", "implicit-euler", "newmark", "generalized-alpha", "bdf2",
                                 "central-difference", "avf", "linearly-implicit"}) {
    const test::RunFolder folder;
    test::run(folder.prepare("[time]\nstep = 1e-3\nend = 1\nintegrator = '" + name +
                             "'\n[damping]\nratio = 0.1\n[[load]]\nset = 'tip'\ntotal = [0, 0, 18]\n" +
                             "[[probe]]\nname = 'p'\nset = 'tip'\n"));
    const double a = .3, w = 3 * std::sqrt(1 - .01);
    const double tip = 1 - std::exp(-a) * (std::cos(w) + a / w * std::sin(w));
    EXPECT_NEAR(test::read_csv(folder / "probes.csv").rows.back()[3], tip, name == "implicit-euler" ? 5e-3 : 5e-6)
        << name;
  }
}

TEST(Run, StaticsRampTheLoad) {
  const test::RunFolder folder;
  const auto said =
      test::run(folder.prepare("gravity = [0, 0, -9]\n[static]\nsteps = 4\n[[probe]]\nname = 'left'\nvertex = 10\n"));
  EXPECT_THAT(said, HasSubstr("4 load steps"));
  const auto csv = test::read_csv(folder / "probes.csv");
  ASSERT_EQ(csv.rows.size(), 5u);
  for (std::size_t n = 0; n < 5; ++n) {
    EXPECT_EQ(csv.rows[n][0], .25 * static_cast<double>(n));
    EXPECT_NEAR(csv.rows[n][3], -9. / 4 * .25 * static_cast<double>(n), 1e-14);  // -g/ω²
  }
}

TEST(Run, FramesCanBeFewOrNone) {
  const test::RunFolder folder;
  auto options = folder.prepare("[time]\nstep = 0.001\nend = 1\n");
  options.frames = 3;
  test::run(options);
  EXPECT_THAT(test::read_numbers(folder / "motion.h5", "/frame_times").values, ElementsAre(0, .5, 1));
  EXPECT_THAT(test::read_numbers(folder / "motion.h5", "/times").shape, ElementsAre(1001));
  EXPECT_THAT(folder.outputs(), ElementsAre("motion.h5", "motion.xdmf"));
}

TEST(Run, FramesAreInSinglePrecisionUnlessAskedForInDouble) {
  const test::RunFolder folder;
  const std::string scene = "[time]\nstep = 0.1\nend = 2\n[[load]]\nset = 'tip'\ntotal = [0, 0, 18]\n";
  auto options = folder.prepare(scene);
  options.frame_numbers = format::Stored::float64;
  test::run(options);
  const auto wide = test::read_numbers(folder / "motion.h5", "/displacement").values;
  options.frame_numbers = RunOptions{}.frame_numbers;
  test::run(options);
  for (const auto* name : {"/displacement", "/frames/3"}) {
    const format::File file(H5Fopen((folder / "motion.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    const format::Dataset dataset(H5Dopen2(file.get(), name, H5P_DEFAULT));
    const format::Type type(H5Dget_type(dataset.get()));
    EXPECT_GT(H5Tequal(type.get(), H5T_IEEE_F32LE), 0) << name;
  }
  const auto narrow = test::read_numbers(folder / "motion.h5", "/displacement").values;
  ASSERT_EQ(narrow.size(), wide.size());
  for (std::size_t i = 0; i < wide.size(); ++i) EXPECT_EQ(narrow[i], double(float(wide[i]))) << i;

  options = folder.prepare("[time]\nstep = 0.1\nend = 2\n[[load]]\nset = 'tip'\ntotal = [0, 0, 1e45]\n");
  EXPECT_THAT([&] { test::run(options); }, ThrowsMessage<NumericalError>(HasSubstr("say --double-frames")));
  options.frame_numbers = format::Stored::float64;
  test::run(options);
}

TEST(Run, WithoutFramesNeedsNoBasis) {
  const test::RunFolder folder;
  auto options = folder.prepare("[time]\nstep = 1\nend = 1\n[[probe]]\nname = 'p'\nset = 'tip'\n");
  test::spoil_basis(options.model);
  options.frames = 0;
  test::run(options);
  EXPECT_THAT(folder.outputs(), ElementsAre("motion.h5", "probes.csv"));
  EXPECT_THAT(test::read_numbers(folder / "motion.h5", "/displacement").shape, IsEmpty());
}

TEST(Run, StepsAreTimedOneByOne) {
  const test::RunFolder folder;
  auto options = folder.prepare("[time]\nstep = 0.25\nend = 1\n");
  options.timing = folder / "timing.csv";
  test::run(options);
  EXPECT_THAT(folder.outputs(), ElementsAre("motion.h5", "motion.xdmf", "timing.csv"));
  const auto csv = test::read_csv(folder / "timing.csv");
  EXPECT_EQ(csv.header, "t,microseconds,iterations,rejected");
  ASSERT_EQ(csv.rows.size(), 4u);
  for (std::size_t n = 0; n < 4; ++n) {
    EXPECT_EQ(csv.rows[n][0], .25 * static_cast<double>(n + 1));
    EXPECT_GT(csv.rows[n][1], 0);
    EXPECT_EQ(csv.rows[n][2], 0);
  }
}

TEST(Run, QuietSaysNothing) {
  const test::RunFolder folder;
  auto options = folder.prepare("[time]\nstep = 1\nend = 1\n");
  options.voice = Voice::quiet;
  EXPECT_EQ(test::run(options), "");
}

TEST(Run, SwingsAMode) {
  const test::RunFolder folder;
  auto options = folder.prepare("");
  options.scene.clear();
  options.animate_mode = 2;
  options.frame_numbers = format::Stored::float64;
  test::run(options);
  const auto u = test::read_numbers(folder / "motion.h5", "/displacement");
  const auto t = test::read_numbers(folder / "motion.h5", "/frame_times").values;
  ASSERT_THAT(u.shape, ElementsAre(40, 4, 3));
  const double amplitude = .1 * std::sqrt(3);  // the box around the four vertices
  EXPECT_NEAR(std::abs(u.values[12 * 10 + 5]), amplitude, 1e-15);
  for (std::size_t k = 0; k < t.size(); ++k)
    EXPECT_NEAR(u.values[12 * k + 5], std::copysign(amplitude, u.values[12 * 10 + 5]) * std::sin(3 * t[k]), 1e-14);
}

/// The run must fail with `complaint` and leave nothing behind but what was there.
template <class Error = InputError>
void expect_refusal(const test::RunFolder& folder, const RunOptions& options, const std::string& complaint) {
  const auto before = folder.outputs();
  try {
    test::run(options);
    ADD_FAILURE() << "accepted, should say " << complaint;
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(complaint));
    EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
  }
  EXPECT_EQ(folder.outputs(), before) << complaint;
}

TEST(RunRefuses, WhatIsWrongAndLeavesNothingBehind) {
  const test::RunFolder folder;
  const std::string time = "[time]\nstep = 0.1\nend = 1\n";
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"", "needs [time]"},
      {time + "[[load]]\nset = 'tpi'\ntotal = [0, 0, 1]", "did you mean 'tip'?"},
      {time + "[[load]]\nvertex = 3\ntotal = [0, 0, 1]", "no vertex 3"},
      {time + "[[load]]\nset = 'tip'\npressure = 1", "needs a surface"},
      {time + "[[probe]]\nname = 'p'\nset = 'tpi'", "did you mean 'tip'?"},
      {time + "[[probe]]\nname = 'p'\nvertex = 3", "no vertex 3"},
      {"[time]\nstep = 1\nend = 3\nintegrator = 'central-difference'", "unstable"},
  };
  for (const auto& [scene, complaint] : bad) expect_refusal(folder, folder.prepare(scene), complaint);
}

TEST(RunRefuses, NumbersThatAreNotFinite) {
  const test::RunFolder folder;
  const std::string load = "[[load]]\nset = 'tip'\ntotal = [0, 0, 1e308]\ntable = [[0, 0], [0.5, 1e10]]\n";
  expect_refusal<NumericalError>(folder, folder.prepare("[time]\nstep = 0.1\nend = 1\n" + load), "is not finite");
  expect_refusal<NumericalError>(folder, folder.prepare("[static]\nsteps = 3\n" + load), "is not finite");
}

TEST(RunRefuses, ToRestAFreeBody) {
  const test::RunFolder folder;
  auto model = test::sample_model();
  model.bodies[0].modes->kinds[0] = model::ModeKind::rigid;
  model.bodies[0].modes->eigenvalues[0] = 0;
  auto options = folder.prepare("[static]\nsteps = 1\n[[load]]\nvertex = 10\ntotal = [0, 0, 1]", model);
  expect_refusal(folder, options, "the body is free");
  options.scene.clear();
  options.animate_mode = 1;
  expect_refusal(folder, options, "mode 1 is rigid and does not swing; the flexible ones start at 2");
  options.animate_mode = 3;
  expect_refusal(folder, options, "--animate-mode is 1 to 2");
}

TEST(RunRefuses, PartsThatAreMissingOrDoNotFit) {
  const test::RunFolder folder;
  const std::string time = "[time]\nstep = 1\nend = 1\n";
  auto model = test::sample_model();
  model.bodies[0].inertia.reset();
  expect_refusal(folder, folder.prepare("gravity = [0, 0, 1]\n" + time, model), "the inertia is missing");
  model = test::sample_model();
  model.bodies[0].modes.reset();
  expect_refusal(folder, folder.prepare(time, model), "the modes are missing");
}

TEST(RunRefuses, OutputsThatCannotBe) {
  const test::RunFolder folder;
  auto options = folder.prepare("[time]\nstep = 1\nend = 1\n");
  const auto size = std::filesystem::file_size(options.model);
  options.output = options.model;
  expect_refusal(folder, options, "--output");
  options.output = folder / "motion.h5";
  options.timing = options.model;
  expect_refusal(folder, options, "--timing");
  for (const auto* beside : {"motion.h5", "motion.xdmf", "./motion.h5"}) {
    options.timing = folder / beside;
    expect_refusal(folder, options, "writes besides");
  }
  options.timing = folder / "nowhere" / "timing.csv";
  expect_refusal(folder, options, "nowhere");
  options.timing.clear();
  EXPECT_EQ(std::filesystem::file_size(options.model), size);
  options.output = folder / "nowhere/motion.h5";
  expect_refusal(folder, options, "there is no folder");
  options.output = folder / "motion.xdmf";
  expect_refusal(folder, options, "end it in .h5");
  std::filesystem::create_directory(folder / "folder.h5");
  options.output = folder / "folder.h5";
  expect_refusal(folder, options, "is a folder");
  std::filesystem::create_symlink("elsewhere", folder / "link.h5");
  options.output = folder / "link.h5";
  expect_refusal(folder, options, "is a symbolic link");
  options.output = "/dev/null";
  expect_refusal(folder, options, "is a device");
}

TEST(RunRefuses, AndKeepsTheLastGoodMotion) {
  const test::RunFolder folder;
  test::run(folder.prepare("[time]\nstep = 1\nend = 1\n"));
  expect_refusal(folder, folder.prepare("[time]\nstep = 1\nend = 5\nintegrator = 'central-difference'"), "unstable");
  EXPECT_THAT(test::read_numbers(folder / "motion.h5", "/times").values, ElementsAre(0, 1));
}

}  // namespace
}  // namespace ritz::tools
