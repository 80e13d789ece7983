// Scenes from beginning to end, and the reasons why one may stop.
#include "ritz/world/run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/nonlinear_sample_model.hpp"
#include "support/sample_model.hpp"

namespace ritz::world {
namespace {

scene::Scene pulled(decltype(scene::Scene::analysis) analysis, double newton) {
  scene::Scene scene{.analysis = analysis, .damping = {}, .gravity = {}, .shake = {}, .loads = {}, .probes = {}};
  scene.loads.push_back({.target = "tip", .kind = scene::TotalForce{{0, 0, newton}}, .table = {}});
  return scene;
}

struct Seen {
  std::vector<double> times;
  std::vector<StepCost> costs;
  RunResult result;
};

Seen see(const scene::Scene& scene, const model::Body& body, Precision precision = Precision::twofold) {
  Seen seen;
  seen.result = run(scene, body, precision,
                    {.state = [&](double t, const auto&) { seen.times.push_back(t); },
                     .cost = [&](const StepCost& cost) { seen.costs.push_back(cost); }});
  return seen;
}

const scene::Time second{.step = .1, .end = 1, .integrator = {}};

TEST(Run, TellsEveryStateAndWhatEachStepTook) {
  const auto seen = see(pulled(second, 20), test::nonlinear_sample_model().bodies[0]);
  ASSERT_EQ(seen.times.size(), 11u);
  ASSERT_EQ(seen.costs.size(), 10u);
  EXPECT_DOUBLE_EQ(seen.times[7], .7);
  int iterations = 0;
  for (const auto& cost : seen.costs) iterations += cost.iterations;
  EXPECT_EQ(seen.result.iterations, iterations);
  EXPECT_GT(iterations, 0);
  EXPECT_FALSE(seen.result.failure);
}

TEST(Run, WatchesTheEnergyOfNonlinearMotionsAlone) {
  const auto nonlinear = see(pulled(second, 20), test::nonlinear_sample_model().bodies[0]).result;
  ASSERT_TRUE(nonlinear.energy);
  EXPECT_LE(nonlinear.energy->largest_drift, 1e-9 * nonlinear.energy->available);
  EXPECT_GT(nonlinear.energy->work, 0);
  EXPECT_FALSE(nonlinear.gain);
  EXPECT_FALSE(see(pulled(second, 20), test::sample_model().bodies[0]).result.energy);
}

TEST(Run, NamesTheStepThatFailed) {
  const double endless = std::numeric_limits<double>::infinity();
  for (const auto& body : {test::sample_model().bodies[0], test::nonlinear_sample_model().bodies[0]}) {
    auto scene = pulled(second, 1);
    scene.loads[0].table = scene::Table{{{.25, 0}, {.3, endless}}};
    const auto seen = see(scene, body);
    ASSERT_TRUE(seen.result.failure);
    EXPECT_EQ(seen.result.failure->cause, Cause::not_finite);
    EXPECT_EQ(seen.result.failure->step, 3);
    EXPECT_EQ(seen.times.size(), 3u);  // nothing is told of a state that is not one
  }
}

TEST(Run, StaticsEndAtALimitPointAndSayHowFarTheyCame) {
  auto body = test::nonlinear_sample_model().bodies[0];
  body.polynomial->quartic[4] *= -1;  // softening: f = 9 z - 4 z³ is at most 3√3
  const auto seen = see(pulled(scene::Static{.steps = 10}, 2 * 3 * std::sqrt(3) * std::sqrt(2)), body);
  ASSERT_TRUE(seen.result.failure);
  EXPECT_EQ(seen.result.failure->cause, Cause::limit_point);
  EXPECT_NEAR(seen.result.failure->t, .5, 1e-3);
  EXPECT_LT(seen.result.failure->softest, .1 * seen.result.failure->softest_at_rest);
  EXPECT_EQ(seen.times.size(), 6u);
}

}  // namespace
}  // namespace ritz::world
