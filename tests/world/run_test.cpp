// Scenes from beginning to end, and the reasons why one may stop.
#include "ritz/world/run.hpp"

#include <gmock/gmock.h>
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

Seen see(const scene::Scene& scene, const model::Body& body, Precision precision = Precision::float64) {
  Seen seen;
  seen.result = run(scene, body, precision,
                    {.state = [&](const Moment& now) { seen.times.push_back(now.t); },
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

/// A scene of bodies "a", "b", ..., each pulled with so many newtons.
scene::Scene of_several(decltype(scene::Scene::analysis) analysis, const std::vector<double>& newtons) {
  auto scene = pulled(analysis, 0);
  scene.loads.clear();
  for (const double newton : newtons) {
    const std::string name(1, static_cast<char>('a' + scene.bodies.size()));
    scene.bodies.push_back({.name = name, .model = {}, .model_body = {}});
    scene.loads.push_back({.target = "tip", .kind = scene::TotalForce{{0, 0, newton}}, .table = {}, .body = name});
  }
  return scene;
}

struct Told {
  std::size_t body;
  double t;
  Eigen::VectorXd z;
};

TEST(Run, MovesSeveralBodiesSideBySideAsIfEachWereAlone) {
  const auto linear = test::sample_model().bodies[0], nonlinear = test::nonlinear_sample_model().bodies[0];
  const std::vector<const model::Body*> models = {&nonlinear, &linear, &nonlinear};
  const std::vector<double> newtons = {20, -3, 5};
  for (const decltype(scene::Scene::analysis) analysis :
       {decltype(scene::Scene::analysis)(second), {scene::Static{3}}}) {
    std::vector<Told> told;
    std::vector<Observer> observers;
    for (std::size_t i = 0; i < 3; ++i)
      observers.push_back({.state =
                               [&told, i](const Moment& now) {
                                 told.push_back({i, now.t, now.z});
                               },
                           .cost = [](const StepCost&) {}});
    std::vector<Actor> actors;
    for (std::size_t i = 0; i < 3; ++i) actors.push_back({models[i], &observers[i], {}});
    const auto results = run(of_several(analysis, newtons), actors, Precision::float64);
    ASSERT_EQ(results.size(), 3u);
    for (std::size_t n = 0; n < told.size(); ++n) {
      EXPECT_EQ(told[n].body, n % 3);
      EXPECT_EQ(told[n].t, told[n - n % 3].t);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      std::size_t n = i;
      const auto alone = run(pulled(analysis, newtons[i]), *models[i], Precision::float64,
                             {.state =
                                  [&](const Moment& now) {
                                    ASSERT_LT(n, told.size());
                                    EXPECT_EQ(told[n].z, now.z);
                                    n += 3;
                                  },
                              .cost = [](const StepCost&) {}});
      EXPECT_EQ(n, told.size() + i);
      EXPECT_EQ(results[i].iterations, alone.iterations);
      EXPECT_EQ(results[i].energy.has_value(), alone.energy.has_value());
    }
  }
}

TEST(Run, OfSeveralBodiesEndsWithTheFirstThatFails) {
  const auto body = test::sample_model().bodies[0];
  const double endless = std::numeric_limits<double>::infinity();
  auto scene = of_several(second, {1, 1});
  scene.loads[1].table = scene::Table{{{.25, 0}, {.3, endless}}};
  int states = 0;
  const Observer count{.state = [&](const Moment&) { ++states; }, .cost = [](const StepCost&) {}};
  const std::vector<Actor> actors(2, Actor{&body, &count, {}});
  const auto results = run(scene, actors, Precision::float64);
  EXPECT_FALSE(results[0].failure);
  ASSERT_TRUE(results[1].failure);
  EXPECT_EQ(results[1].failure->step, 3);
  EXPECT_EQ(states, 7);
}

TEST(Run, GoesOnFromWhereItStopped) {
  const auto body = test::nonlinear_sample_model().bodies[0];
  auto scene = pulled(second, 20);
  scene.probes.push_back({.name = "tip", .target = "tip", .quantities = {scene::Quantity::acceleration}});
  const auto run_on = [&](double end, const Start& start) {
    std::vector<Moment> moments;
    scene.analysis = scene::Time{.step = .1, .end = end, .integrator = scene::Integrator::newmark};
    const Observer observer{.state = [&](const Moment& now) { moments.push_back(now); },
                            .cost = [](const StepCost&) {}};
    const Actor actor{&body, &observer, start};
    auto result = run(scene, std::span(&actor, 1), Precision::float64).front();
    return std::pair(std::move(moments), std::move(result));
  };
  const auto [whole, all] = run_on(4, {});
  const auto [before, half] = run_on(1.7, {});
  ASSERT_TRUE(half.last);
  EXPECT_EQ(half.last->steps, 17);
  const auto [after, rest] = run_on(4, *half.last);
  EXPECT_EQ(rest.steps, 23);
  ASSERT_EQ(after.size(), 24u);
  for (std::size_t n = 0; n < after.size(); ++n) {
    const auto& same = whole[17 + n];
    EXPECT_EQ(after[n].t, same.t);
    EXPECT_EQ(after[n].z, same.z);
    EXPECT_EQ(after[n].velocity, same.velocity);
    EXPECT_EQ(after[n].acceleration, same.acceleration);
  }
  EXPECT_EQ(rest.energy->work, all.energy->work);
  EXPECT_EQ(rest.energy->gained, all.energy->gained);
  EXPECT_EQ(rest.energy->lost, all.energy->lost);
  EXPECT_EQ(rest.iterations + half.iterations, all.iterations);
  Checkpoint other = *half.last;
  other.history.conservativeResize(Eigen::NoChange, 2);
  EXPECT_THROW(run_on(4, other), InputError);
  EXPECT_THROW(run_on(4, GivenStart{Eigen::VectorXd::Zero(3), Eigen::VectorXd::Zero(3)}), InputError);
}

TEST(Run, OfANonlinearBodyCountsTheEnergyThatItStartsWith) {
  auto scene = pulled(second, 0);
  scene.initial = scene::CoordinateStart{.z = {0, 1}, .velocity = {0, 2}};
  const auto result = see(scene, test::nonlinear_sample_model().bodies[0]).result;
  EXPECT_NEAR(result.energy->start, 4. / 2 + 9. / 2 + 1, 1e-14);  // ½ z'² + ½ 9 z² + ¼ (2 z²)²
  EXPECT_LE(result.energy->largest_drift, 1e-9 * result.energy->start);
}

TEST(Run, NamesTheBodyThatALoadDoesNotFit) {
  const auto body = test::sample_model().bodies[0];
  auto scene = of_several(second, {1, 1});
  scene.loads[1].target = "tpi";
  const Observer nobody{.state = [](const Moment&) {}, .cost = [](const StepCost&) {}};
  const std::vector<Actor> actors(2, Actor{&body, &nobody, {}});
  EXPECT_THAT([&] { run(scene, actors, Precision::float64); },
              testing::ThrowsMessage<InputError>(testing::StartsWith("body 'b': ")));
}

}  // namespace
}  // namespace ritz::world
