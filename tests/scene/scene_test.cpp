#include "ritz/scene_file/read.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "ritz/base/error.hpp"
#include "scene/temporary_scene.hpp"

namespace ritz::scene {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(Scene, EveryKey) {
  const test::TemporaryScene file(R"(
gravity = [0, 0, -9.81]
[time]
step = 1e-3
end = 2
integrator = "generalized-alpha"
[damping]
alpha = 0.1
beta = 1e-4
ratio = [0.01, 0.02]
[shake]
direction = [1, 0, 0]
table = [[0, 0], [1, 2.5]]
[[load]]
set = "tip"
total = [0, 0, -1]
table = [[0, 0], [0.5, 1], [1, 0]]
[[load]]
vertex = 17
each = [1, 2, 3]
[[load]]
set = "skin"
pressure = 1e5
[[load]]
set = "skin"
traction = [1, 0, 0]
[[probe]]
name = "tip"
set = "tip"
[[probe]]
name = "v"
vertex = 4
quantity = "acceleration"
[[probe]]
name = "all"
vertex = 4
quantity = ["velocity", "displacement"]
[initial]
z = [1, 2.5]
)");
  const Scene scene = read(file.path());
  const auto& time = std::get<Time>(scene.analysis);
  EXPECT_EQ(time.step, 1e-3);
  EXPECT_EQ(time.end, 2);
  EXPECT_EQ(time.integrator, Integrator::generalized_alpha);
  EXPECT_EQ(scene.damping.alpha, .1);
  EXPECT_EQ(scene.damping.beta, 1e-4);
  EXPECT_THAT(scene.damping.ratio, ElementsAre(.01, .02));
  EXPECT_THAT(scene.gravity, testing::Optional(ElementsAre(0, 0, -9.81)));
  EXPECT_THAT(scene.shake->direction, ElementsAre(1, 0, 0));
  EXPECT_THAT(scene.shake->table.points, ElementsAre(Pair(0, 0), Pair(1, 2.5)));
  ASSERT_EQ(scene.loads.size(), 4u);
  EXPECT_EQ(std::get<std::string>(scene.loads[0].target), "tip");
  EXPECT_THAT(std::get<TotalForce>(scene.loads[0].kind).newton, ElementsAre(0, 0, -1));
  EXPECT_THAT(scene.loads[0].table->points, ElementsAre(Pair(0, 0), Pair(.5, 1), Pair(1, 0)));
  EXPECT_EQ(std::get<std::int64_t>(scene.loads[1].target), 17);
  EXPECT_THAT(std::get<EachForce>(scene.loads[1].kind).newton, ElementsAre(1, 2, 3));
  EXPECT_FALSE(scene.loads[1].table);
  EXPECT_EQ(std::get<Pressure>(scene.loads[2].kind).pascal, 1e5);
  EXPECT_THAT(std::get<Traction>(scene.loads[3].kind).pascal, ElementsAre(1, 0, 0));
  ASSERT_EQ(scene.probes.size(), 3u);
  EXPECT_EQ(scene.probes[0].name, "tip");
  EXPECT_EQ(std::get<std::int64_t>(scene.probes[1].target), 4);
  EXPECT_THAT(scene.probes[0].quantities, ElementsAre(Quantity::displacement));
  EXPECT_THAT(probe_columns(scene.probes), ElementsAre("tip_ux", "tip_uy", "tip_uz", "v_ax", "v_ay", "v_az", "all_vx",
                                                       "all_vy", "all_vz", "all_ux", "all_uy", "all_uz"));
  EXPECT_TRUE(any_measures(scene.probes, Quantity::velocity));
  EXPECT_THAT(std::get<CoordinateStart>(*scene.initial).z, ElementsAre(1, 2.5));
  EXPECT_THAT(std::get<CoordinateStart>(*scene.initial).velocity, testing::IsEmpty());
}

TEST(Scene, ThatNamesNoBodiesHasOneWithoutAName) {
  const test::TemporaryScene file("[static]\nsteps = 1\n[[load]]\nset = 'tip'\ntotal = [0, 0, 1]\n");
  const Scene scene = read(file.path());
  EXPECT_TRUE(scene.bodies.empty());
  EXPECT_EQ(scene.loads[0].body, "");
}

TEST(Scene, OfSeveralBodiesSaysWhatIsDoneToEach) {
  const std::string text = R"(
gravity = [0, 0, -1]
[static]
steps = 1
[[body]]
name = "arm"
model = "models/arm.h5"
model_body = "upper"
[[body]]
name = "ball"
model = "/far/ball.h5"
[[body]]
name = "other"
[[load]]
body = "ball"
set = "tip"
total = [0, 0, 1]
[[load]]
body = "arm"
set = "end"
total = [0, 0, 1]
[[probe]]
name = "p"
body = "ball"
vertex = 7
)";
  const Scene scene = parse(text, "scenes/two.toml");
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[0].model, "scenes/models/arm.h5");  // from the scene's own folder
  EXPECT_EQ(scene.bodies[0].model_body, "upper");
  EXPECT_EQ(scene.bodies[1].model, "/far/ball.h5");
  EXPECT_TRUE(scene.bodies[2].model.empty());
  const auto ball = of_body(scene, "ball"), other = of_body(scene, "other");
  ASSERT_EQ(ball.loads.size(), 1u);
  EXPECT_EQ(std::get<std::string>(ball.loads[0].target), "tip");
  EXPECT_EQ(ball.probes.size(), 1u);
  EXPECT_TRUE(ball.bodies.empty());
  EXPECT_TRUE(other.loads.empty());
  EXPECT_TRUE(other.probes.empty());
  EXPECT_EQ(other.gravity, scene.gravity);  // gravity acts on all
}

TEST(Scene, SaysHowEachBodyStarts) {
  const std::string bodies = "[[body]]\nname = 'a'\ninitial = { static = true }\n[[body]]\nname = 'b'\n";
  const auto scene =
      parse("time = {step = 1, end = 1}\n" + bodies + "[initial]\nmotion = 'm.h5'\ntime = 2\n", "in/s.toml");
  EXPECT_TRUE(std::holds_alternative<StaticStart>(*of_body(scene, "a").initial));
  const auto stored = std::get<StoredStart>(*of_body(scene, "b").initial);
  EXPECT_EQ(stored.motion, "in/m.h5");
  EXPECT_THAT(stored.time, testing::Optional(2.));
  EXPECT_TRUE(stored.model.empty());
  EXPECT_FALSE(parse("time = {step = 1, end = 1}\n", "s.toml").initial);
}

TEST(Scene, TheLeastScenes) {
  const Scene dynamic = read(test::TemporaryScene("time = {step = 1, end = 1}").path());
  EXPECT_FALSE(std::get<Time>(dynamic.analysis).integrator);
  EXPECT_FALSE(dynamic.gravity);
  EXPECT_EQ(std::get<Static>(read(test::TemporaryScene("[static]\nsteps = 4").path()).analysis).steps, 4);
}

TEST(Scene, OfATableIsTheOneOfTheFileThatSaysTheSame) {
  using Table = Value::Table;
  using Array = Value::Array;
  const Value pull{Array{{std::int64_t{0}}, {0.5}, {-1.5}}};
  const Value ramp{Array{{Array{{0.0}, {0.0}}}, {Array{{std::int64_t{1}}, {2.0}}}}};
  const Value load{Table{{"set", {std::string("tip")}}, {"total", pull}, {"table", ramp}}};
  const Scene scene = from_table({{"static", {Table{{"steps", {std::int64_t{3}}}}}}, {"load", {Array{load}}}}, "it");
  EXPECT_EQ(std::get<Static>(scene.analysis).steps, 3);
  ASSERT_EQ(scene.loads.size(), 1U);
  EXPECT_EQ(std::get<std::string>(scene.loads[0].target), "tip");
  EXPECT_EQ(std::get<TotalForce>(scene.loads[0].kind).newton, (Vector3{0, 0.5, -1.5}));
  EXPECT_THAT(scene.loads[0].table->points, ElementsAre(Pair(0, 0), Pair(1, 2)));
}

TEST(Scene, OfATableIsRefusedWithoutALine) {
  const auto says = [](const char* message) { return testing::ThrowsMessage<InputError>(testing::StrEq(message)); };
  using Table = Value::Table;
  EXPECT_THAT(
      [] {
        from_table({{"static", {Table{{"steps", {2.5}}}}}}, "it");
      },
      says("it: 'steps' of [static] must be a whole number"));
  EXPECT_THAT(
      [] {
        from_table({{"static", {Table{{"step", {std::int64_t{2}}}}}}}, "it");
      },
      says("it: unknown key 'step' in [static]; did you mean 'steps'?"));
  EXPECT_THAT([] { from_table({{"static", {true}}}, "it"); }, says("it: [static] must be a table of keys"));
}

TEST(Scene, LineEndingsOfWindows) {
  const Scene scene = read(test::TemporaryScene("[time]\r\nstep = 0.5\r\nend = 1\r\n").path());
  EXPECT_EQ(std::get<Time>(scene.analysis).step, .5);
}

TEST(Scene, OneRatioForAllModes) {
  const Scene scene = read(test::TemporaryScene("time = {step = 1, end = 1}\ndamping = {ratio = 0.05}").path());
  EXPECT_THAT(scene.damping.ratio, ElementsAre(.05));
}

TEST(Scene, EveryIntegratorByItsName) {
  for (std::size_t i = 0; i < integrator_names.size(); ++i) {
    const std::string text = "[time]\nstep = 1\nend = 1\nintegrator = '" + std::string(integrator_names[i]) + "'";
    EXPECT_EQ(std::get<Time>(read(test::TemporaryScene(text).path()).analysis).integrator, static_cast<Integrator>(i));
  }
}

TEST(Table, IsLinearBetweenAndHeldOutside) {
  const Table table{{{1, 10}, {2, 20}, {4, -20}}};
  EXPECT_EQ(table.at(-5), 10);
  EXPECT_EQ(table.at(1), 10);
  EXPECT_EQ(table.at(1.25), 12.5);
  EXPECT_EQ(table.at(2), 20);
  EXPECT_EQ(table.at(3), 0);
  EXPECT_EQ(table.at(4), -20);
  EXPECT_EQ(table.at(1e9), -20);
  EXPECT_EQ((Table{{{0, 3}}}).at(7), 3);
}

TEST(Time, CountsSteps) {
  EXPECT_EQ(step_count({.step = .1, .end = 1, .integrator = {}}), 10);
  EXPECT_EQ(step_count({.step = .3, .end = 1, .integrator = {}}), 4);
  EXPECT_EQ(step_count({.step = 1, .end = 1, .integrator = {}}), 1);
  EXPECT_EQ(step_count({.step = 1. / 44100, .end = 10, .integrator = {}}), 441000);
}

TEST(Factor, RampsInStaticsUnlessTheLoadHasATable) {
  Scene scene{.analysis = Time{.step = 1, .end = 2, .integrator = {}},
              .damping = {},
              .gravity = {},
              .shake = {},
              .loads = {},
              .probes = {}};
  const Table half{{{0, .5}}};
  EXPECT_EQ(factor(scene, {}, .25), 1);
  EXPECT_EQ(factor(scene, half, .25), .5);
  scene.analysis = Static{4};
  EXPECT_EQ(factor(scene, {}, .25), .25);
  EXPECT_EQ(factor(scene, half, .25), .5);
}

TEST(Frames, AreAllOrThinned) {
  EXPECT_THAT(frame_schedule({}, 3), ElementsAre(0, 1, 2, 3));
  const auto thinned = frame_schedule({}, 100000);
  EXPECT_EQ(thinned.size(), 201u);
  EXPECT_EQ(thinned[1], 500);
  EXPECT_EQ(thinned.back(), 100000);
}

TEST(Frames, ByNumber) {
  EXPECT_THAT(frame_schedule({.frames = 3, .every = {}}, 10), ElementsAre(0, 5, 10));
  EXPECT_THAT(frame_schedule({.frames = 4, .every = {}}, 10), ElementsAre(0, 3, 7, 10));
  EXPECT_THAT(frame_schedule({.frames = 1, .every = {}}, 10), ElementsAre(10));
  EXPECT_THAT(frame_schedule({.frames = 0, .every = {}}, 10), ElementsAre());
  EXPECT_THAT(frame_schedule({.frames = 99, .every = {}}, 2), ElementsAre(0, 1, 2));
}

TEST(Frames, EverySoManySteps) {
  EXPECT_THAT(frame_schedule({.frames = {}, .every = 4}, 10), ElementsAre(0, 4, 8));
  EXPECT_THAT(frame_schedule({.frames = {}, .every = 400}, 10), ElementsAre(0));
}

// As it stands it is a scene, and the lines that it offers instead of others are right too.
TEST(Reference, IsASceneWithEveryKey) {
  const std::string text(reference());
  const Scene read = parse(text, "reference.toml");
  ASSERT_TRUE(std::holds_alternative<Time>(read.analysis));
  EXPECT_EQ(read.bodies.size(), 1u);
  EXPECT_EQ(read.loads.size(), 1u);
  EXPECT_EQ(read.probes.size(), 1u);
  EXPECT_TRUE(read.gravity && read.shake && read.loads[0].table && !read.damping.ratio.empty());
  for (const auto name : integrator_names) EXPECT_NE(text.find(name), text.npos) << name;
  const std::string start = text.substr(text.find("z = ["), text.find("# static") - text.find("z = ["));
  for (const std::string other : {"static = true", "motion = \"motion.h5\"", "motion = 'm.h5'\ntime = 0.25",
                                  "motion = 'm.h5'\nmodel = \"model.h5\""}) {
    EXPECT_NE(text.find("# " + other.substr(other.find('\n') + 1)), text.npos) << other;
    std::string changed = text;
    changed.replace(changed.find(start), start.size(), other + "\n");
    EXPECT_NO_THROW(parse(changed, "changed.toml")) << other;
  }
  for (const std::string other : {"each = [0.0, 0.0, -1.0]", "pressure = 1000.0", "traction = [0.0, 0.0, -1e3]"}) {
    ASSERT_NE(text.find("# " + other), text.npos);
    std::string changed = text;
    changed.replace(changed.find("total ="), 0, other + " # ");
    EXPECT_NO_THROW(parse(changed, "changed.toml")) << other;
  }
}

}  // namespace
}  // namespace ritz::scene
