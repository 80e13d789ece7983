// What is written is what is read.
#include "ritz/scene_file/write.hpp"

#include <gmock/gmock.h>

#include "ritz/base/error.hpp"
#include "ritz/scene_file/read.hpp"

namespace ritz::scene {
namespace {

using ::testing::HasSubstr;

TEST(WrittenScene, EveryKeyIsReadAgain) {
  const auto again = [](const std::string& text) { return written(parse(text, "a")); };
  const auto first = again(std::string(reference()));
  EXPECT_EQ(again(first), first) << "a text that holds a scene is written as it was";
  const auto all = parse(first, "b"), known = parse(std::string(reference()), "c");
  EXPECT_EQ(all.gravity, known.gravity);
  EXPECT_EQ(all.shake->table, known.shake->table);
  EXPECT_EQ(all.damping.ratio, known.damping.ratio);
  EXPECT_EQ(std::get<Time>(all.analysis).integrator, std::get<Time>(known.analysis).integrator);
  EXPECT_EQ(all.loads.at(0).table, known.loads.at(0).table);
  EXPECT_EQ(all.probes.at(0).body, known.probes.at(0).body);
  EXPECT_EQ(all.bodies.at(0).model_body, known.bodies.at(0).model_body);
}

TEST(WrittenScene, EveryKindOfLoadKeepsItsDigits) {
  Scene scene{
      .analysis = Static{7}, .damping = {}, .gravity = {}, .shake = {}, .bodies = {}, .loads = {}, .probes = {}};
  scene.loads.push_back({.target = "a \"b\\\t\x7f\u00e9", .kind = EachForce{{1. / 3, -1e-300, 1e22}}, .table = {}});
  scene.loads.push_back(
      {.target = std::int64_t{-5}, .kind = TotalForce{{0, 1, 2}}, .table = Table{{{0, .1}, {1e-9, 1}}}});
  scene.loads.push_back({.target = "s", .kind = Pressure{1e5}, .table = {}});
  scene.loads.push_back({.target = "s", .kind = Traction{{.1, .2, .3}}, .table = {}});
  const auto read = parse(written(scene), "d");
  EXPECT_EQ(std::get<Static>(read.analysis).steps, 7);
  ASSERT_EQ(read.loads.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(read.loads[i].target, scene.loads[i].target);
    EXPECT_EQ(read.loads[i].table, scene.loads[i].table);
  }
  EXPECT_EQ(std::get<EachForce>(read.loads[0].kind).newton, std::get<EachForce>(scene.loads[0].kind).newton);
  EXPECT_EQ(std::get<TotalForce>(read.loads[1].kind).newton, std::get<TotalForce>(scene.loads[1].kind).newton);
  EXPECT_EQ(std::get<Pressure>(read.loads[2].kind).pascal, 1e5);
  EXPECT_EQ(std::get<Traction>(read.loads[3].kind).pascal, std::get<Traction>(scene.loads[3].kind).pascal);
}

TEST(WrittenScene, NamesThatNoFileHolds) {
  Scene scene{
      .analysis = Static{1}, .damping = {}, .gravity = {}, .shake = {}, .bodies = {}, .loads = {}, .probes = {}};
  scene.loads.push_back({.target = "caf\xe9", .kind = Pressure{1}, .table = {}});
  EXPECT_THAT([&] { written(scene); }, ::testing::ThrowsMessage<InputError>(HasSubstr("UTF-8")));
}

}  // namespace
}  // namespace ritz::scene
