// Scenes that name their bodies: each has its own motion, and moves as it would alone.
#include <gmock/gmock.h>

#include "ritz/base/error.hpp"
#include "support/nonlinear_sample_model.hpp"
#include "tools/run_support.hpp"

namespace ritz::tools {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string time = "[time]\nstep = 0.1\nend = 1\n";

std::string pull(const std::string& body, double newton) {
  return "[[load]]\n" + body + "set = 'tip'\ntotal = [0, 0, " + std::to_string(newton) + "]\n";
}

/// Two bodies of model.other.h5, which is nonlinear, and one of the model on the command line.
const std::string three =
    time +
    "[[body]]\nname = 'a'\nmodel = 'model.other.h5'\n[[body]]\nname = 'b/c'\n[[body]]\nname = 'd'\nmodel = "
    "'model.other.h5'\n" +
    pull("body = 'a'\n", 20) + pull("body = 'b/c'\n", 18) + pull("body = 'd'\n", -4) +
    "[[probe]]\nname = 'last'\nbody = 'd'\nset = 'tip'\n[[probe]]\nname = 'first'\nbody = 'a'\nset = 'tip'\n";

RunOptions prepare_three(const test::RunFolder& folder) {
  auto options = folder.prepare(three);
  format::write(folder / "model.other.h5", test::nonlinear_sample_model());
  return options;
}

TEST(RunBodies, HaveEachAMotionOfItsOwn) {
  const test::RunFolder folder;
  const auto said = test::run(prepare_three(folder));
  EXPECT_THAT(folder.outputs(), ElementsAre("motion.a.h5", "motion.a.xdmf", "motion.b%2Fc.h5", "motion.b%2Fc.xdmf",
                                            "motion.d.h5", "motion.d.xdmf", "probes.csv"));
  EXPECT_THAT(said,
              AllOf(HasSubstr("body 'a': 10 steps"), HasSubstr("body 'b/c': 10 steps"), HasSubstr("body 'd': 10")));
}

TEST(RunBodies, MoveAsTheyWouldAlone) {
  const test::RunFolder folder;
  test::run(prepare_three(folder));
  const auto together = test::read_csv(folder / "probes.csv");
  EXPECT_EQ(together.header, "t,last_ux,last_uy,last_uz,first_ux,first_uy,first_uz");
  ASSERT_EQ(together.rows.size(), 11u);
  for (const auto& [body, newton, column] : {std::tuple{"a", 20., 6}, {"d", -4., 3}}) {
    const test::RunFolder alone;
    test::run(alone.prepare(time + pull("", newton) + "[[probe]]\nname = 'p'\nset = 'tip'\n",
                            test::nonlinear_sample_model()));
    const auto csv = test::read_csv(alone / "probes.csv");
    for (std::size_t n = 0; n < 11; ++n)
      EXPECT_EQ(together.rows[n][static_cast<std::size_t>(column)], csv.rows[n][3]) << body;
    EXPECT_EQ(test::read_numbers(folder / ("motion." + std::string(body) + ".h5"), "/z").values,
              test::read_numbers(alone / "motion.h5", "/z").values);
  }
}

TEST(RunBodies, OfOneFileAreChosenByName) {
  const test::RunFolder folder;
  const auto model = test::two_body_model();
  const auto options = folder.prepare(
      time + "[[body]]\nname = 'x'\n[[body]]\nname = 'y'\nmodel_body = '" + model.bodies[1].name + "'\n", model);
  test::run(options);
  EXPECT_EQ(test::read_numbers(folder / "motion.x.h5", "/points").shape[0], model.bodies[0].geometry.points.rows());
  EXPECT_EQ(test::read_numbers(folder / "motion.y.h5", "/points").shape[0], model.bodies[1].geometry.points.rows());
}

TEST(RunBodies, AreSummarisedOneByOne) {
  const test::RunFolder folder;
  auto options = prepare_three(folder);
  options.summary = folder / "run.json";
  options.timing = folder / "timing.csv";
  test::run(options);
  std::ifstream in(options.summary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(text, AllOf(HasSubstr("\"bodies\""), HasSubstr("\"name\": \"b/c\""), HasSubstr("motion.b%2Fc.h5")));
  EXPECT_EQ(test::read_csv(options.timing).rows.size(), 10u);
}

TEST(RunBodies, ThatCannotRunLeaveNothingBehind) {
  struct Bad {
    std::string scene, says;
  };
  const std::vector<Bad> bad = {
      {time + "[[body]]\nname = 'a'\nmodel = 'none.h5'\n[[body]]\nname = 'b'\n", "none.h5"},
      {time + "[[body]]\nname = 'a'\nmodel = 'model.other.h5'\n", "is not used: leave one of them out"},
      {time + "[[body]]\nname = 'a'\nmodel_body = 'boddy'\n", "has no body 'boddy'; did you mean 'body'?"},
      {time + "[[body]]\nname = 'a'\n[[body]]\nname = 'b'\n" + "[[load]]\nbody = 'b'\nset = 'tpi'\ntotal = [1, 0, 0]\n",
       "body 'b': "},
      {time + "integrator = 'exact'\n[[body]]\nname = 'a'\n[[body]]\nname = 'b'\nmodel = 'model.other.h5'\n",
       "body 'b': the integrator 'exact' is for linear models"},
      {time + "[[body]]\nname = 'a'\n" + pull("", 1) +
           "table = [[0, 0], [0.25, 0], [0.3, 1e300]]\n[[load]]\nset = 'tip'\n" +
           "total = [0, 0, 1e300]\ntable = [[0, 0], [0.25, 0], [0.3, 1e300]]\n",
       "body 'a': step"},
  };
  for (const auto& [scene, says] : bad) {
    const test::RunFolder folder;
    auto options = folder.prepare(scene);
    format::write(folder / "model.other.h5", test::nonlinear_sample_model());
    EXPECT_THAT([&] { test::run(options); }, ThrowsMessage<std::runtime_error>(HasSubstr(says)));
    EXPECT_THAT(folder.outputs(), testing::IsEmpty());
  }
  const test::RunFolder folder;
  auto options = folder.prepare(time + "[[body]]\nname = 'a'\n");
  options.model.clear();
  EXPECT_THAT([&] { test::run(options); }, ThrowsMessage<InputError>(HasSubstr("body 'a' has no model")));
}

TEST(RunBodies, GetTheirNamesFromTheOutput) {
  const test::RunFolder folder;
  auto options = folder.prepare(time + "[[body]]\nname = 'a'\n[[body]]\nname = 'b'\n");
  options.output = folder / "moved";
  test::run(options);
  EXPECT_THAT(folder.outputs(), ElementsAre("moved.a.h5", "moved.a.xdmf", "moved.b.h5", "moved.b.xdmf"));
  for (const auto* no_file : {"", ".", "out/"}) {
    options.output = no_file[0] == 'o' ? folder / "out/" : std::filesystem::path(no_file);
    EXPECT_THAT([&] { test::run(options); }, ThrowsMessage<InputError>(HasSubstr("is a folder"))) << no_file;
  }
}

/// A model that no vertex of the scene concerns is read without its basis, whatever other bodies need.
TEST(RunBodies, ReadWhatIsDoneToThemAlone) {
  const test::RunFolder folder;
  auto options = folder.prepare(time +
                                "[[body]]\nname = 'a'\nmodel = 'model.other.h5'\n[[body]]\nname = 'b'\n"
                                "[[probe]]\nname = 'p'\nbody = 'a'\nvertex = 20\n");
  format::write(folder / "model.other.h5", test::nonlinear_sample_model());
  test::spoil_basis(options.model);
  options.frames = 0;
  test::run(options);
  EXPECT_THAT(folder.outputs(), ElementsAre("motion.a.h5", "motion.b.h5", "probes.csv"));
}

}  // namespace
}  // namespace ritz::tools
