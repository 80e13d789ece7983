#include "ritz/world/loads.hpp"

#include <gmock/gmock.h>

#include "ritz/base/error.hpp"
#include "support/sample_model.hpp"

namespace ritz::world {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

const double s = 1 / std::sqrt(2.0);

scene::Scene still() {
  return {.analysis = scene::Time{.step = 1, .end = 2, .integrator = {}},
          .damping = {},
          .gravity = {},
          .shake = {},
          .loads = {},
          .probes = {}};
}

scene::Load load(scene::Target target, decltype(scene::Load::kind) kind) {
  return {.target = std::move(target), .kind = kind, .table = {}};
}

VectorXd force_at(const scene::Scene& scene, double t) {
  const auto model = test::sample_model();
  VectorXd force(2);
  reduce_loads(scene, model.bodies[0]).evaluate(scene, t, force);
  return force;
}

VectorXd force_of(const scene::Load& one) {
  auto scene = still();
  scene.loads = {one};
  return force_at(scene, 0);
}

TEST(ReducedLoads, OfEveryKind) {
  EXPECT_TRUE(force_of(load("tip", scene::TotalForce{{5, 6, 7}})).isApprox(Vector2d(0, 7 * s)));
  EXPECT_TRUE(force_of(load("end/of 50% cells", scene::TotalForce{{0, 0, 7}})).isApprox(Vector2d(3.5 * s, 3.5 * s)));
  EXPECT_TRUE(force_of(load("end/of 50% cells", scene::EachForce{{0, 0, 7}})).isApprox(Vector2d(7 * s, 7 * s)));
  EXPECT_TRUE(force_of(load(std::int64_t{20}, scene::TotalForce{{1, 1, 7}})).isApprox(Vector2d(0, 7 * s)));
  EXPECT_TRUE(force_of(load(std::int64_t{10}, scene::EachForce{{1, 1, 7}})).isApprox(Vector2d(7 * s, 0)));
  EXPECT_TRUE(force_of(load("end/of 50% cells", scene::Pressure{8})).isApprox(Vector2d(1, .5)));
  EXPECT_TRUE(force_of(load("end/of 50% cells", scene::Traction{{1, 2, 8}})).isApprox(Vector2d(1, 1)));
}

TEST(ReducedLoads, GravityWeighsTheMasses) {
  auto scene = still();
  scene.gravity = {1, 2, -9.81};
  EXPECT_TRUE(force_at(scene, 5).isApprox(Vector2d(-9.81 * 2 * s, -9.81 * 2 * s)));  // 2 kg each
}

TEST(ReducedLoads, ShakingPushesAgainstTheGround) {
  auto scene = still();
  scene.shake = {{0, 0, 2}, {{{0, 0}, {1, 3}}}};
  EXPECT_TRUE(force_at(scene, .5).isApprox(Vector2d(-3 * 2 * s, -3 * 2 * s)));
  EXPECT_TRUE(force_at(scene, 9).isApprox(Vector2d(-6 * 2 * s, -6 * 2 * s)));
}

TEST(ReducedLoads, AddUpWithTheirTables) {
  auto scene = still();
  scene.loads = {load("tip", scene::TotalForce{{0, 0, 1}}), load("tip", scene::TotalForce{{0, 0, 10}})};
  scene.loads[1].table = {{{0, 0}, {1, 1}}};
  EXPECT_TRUE(force_at(scene, .25).isApprox(Vector2d(0, 3.5 * s)));
}

TEST(ReducedLoads, RampInStatics) {
  auto scene = still();
  scene.analysis = scene::Static{4};
  scene.loads = {load("tip", scene::TotalForce{{0, 0, 8}})};
  scene.gravity = {0, 0, -1};
  EXPECT_TRUE(force_at(scene, .25).isApprox(Vector2d(-.5 * s, 1.5 * s)));
}

TEST(ProbeMatrix, TakesVerticesAndMeans) {
  auto scene = still();
  scene.probes = {{"v", std::int64_t{20}}, {"set", "end/of 50% cells"}};
  const Eigen::MatrixXd P = probe_matrix(scene, test::sample_model().bodies[0]);
  ASSERT_EQ(P.rows(), 6);
  const VectorXd u = P * Vector2d(4, 6);
  EXPECT_TRUE(u.isApprox((VectorXd(6) << 0, 0, 6 * s, 0, 0, 5 * s).finished()));
}

TEST(ProbeMatrix, KnowsTheMeanOfASetThatIsNotStored) {
  auto scene = still();
  scene.probes = {{"set", "end/of 50% cells"}};
  auto body = test::sample_model().bodies[0];
  body.geometry = {};
  body.basis = {};
  EXPECT_DOUBLE_EQ((probe_matrix(scene, body) * Vector2d(4, 6))[2], 5 * s);
}

void expect_refusal(const model::Body& body, const scene::Load& bad, const std::string& complaint) {
  auto scene = still();
  scene.loads = {bad};
  try {
    reduce_loads(scene, body);
    ADD_FAILURE() << "accepted, should say " << complaint;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(complaint));
  }
}

TEST(ReducedLoads, RefuseWhatTheModelDoesNotHave) {
  auto body = test::sample_model().bodies[0];
  expect_refusal(body, load("tpi", scene::TotalForce{}), "no set 'tpi'; did you mean 'tip'?");
  expect_refusal(
      body, load("tip", scene::Pressure{1}),
      "pressure needs a surface, and the set 'tip' has none; the nearest set with one is 'end/of 50% cells'");
  expect_refusal(body, load("tip", scene::Traction{}), "traction needs a surface");
  expect_refusal(body, load(std::int64_t{11}, scene::TotalForce{}), "no vertex 11, by the mesh file's own numbers");
  expect_refusal(body, load(std::int64_t{11}, scene::TotalForce{}), "from 10 to 41");
  body.geometry.rows = model::Rows::surface;
  expect_refusal(body, load(std::int64_t{11}, scene::TotalForce{}), "holds its surface alone");
  body.loads.clear();
  expect_refusal(body, load("tip", scene::TotalForce{}), "the set 'tip', which is empty");
  body.geometry.sets.clear();
  expect_refusal(body, load("tip", scene::TotalForce{}), "no set 'tip'; it has no named sets");
}

/// The sample model, its sets named so.
model::Body with_sets(const std::string& tip, const std::string& end) {
  auto body = test::sample_model().bodies[0];
  for (auto& load : body.loads) load.set = load.set == "tip" ? tip : end;
  body.geometry.sets = {{tip, {1}, 1}, {end, {0, 1}, 2}};
  return body;
}

VectorXd force_on(const model::Body& body, const scene::Load& one) {
  auto scene = still();
  scene.loads = {one};
  VectorXd force(2);
  reduce_loads(scene, body).evaluate(scene, 0, force);
  return force;
}

TEST(ReducedLoads, TakeTheKindOfSetThatTheLoadIsFor) {
  const auto body = with_sets("nset:grip", "surface:grip");
  const scene::TotalForce pull{{0, 0, 1}};
  EXPECT_EQ(force_on(body, load("grip", pull)), force_of(load("tip", pull)));
  EXPECT_EQ(force_on(body, load("grip", scene::Pressure{2})), force_of(load("end/of 50% cells", scene::Pressure{2})));
  EXPECT_EQ(force_on(body, load("surface:grip", pull)), force_of(load("end/of 50% cells", pull)));
  auto scene = still();
  scene.probes = {{"p", "grip"}};
  const auto of_grip = probe_matrix(scene, body);
  scene.probes = {{"p", "tip"}};
  EXPECT_EQ(of_grip, probe_matrix(scene, test::sample_model().bodies[0]));
}

TEST(ReducedLoads, RefuseANameThatStaysAmbiguous) {
  expect_refusal(with_sets("elset:grip", "surface:grip"), load("grip", scene::TotalForce{}),
                 "several sets 'grip'; say which: 'elset:grip' or 'surface:grip'");
  expect_refusal(with_sets("nset:grip", "elset:grip"), load("grip", scene::Pressure{1}),
                 "several sets 'grip'; say which: 'nset:grip' or 'elset:grip'");
}

}  // namespace
}  // namespace ritz::world
