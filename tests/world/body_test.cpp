// Push a body and step it: no file, no scene.
#include "ritz/world/body.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ritz/base/error.hpp"
#include "support/nonlinear_sample_model.hpp"
#include "support/sample_model.hpp"

namespace ritz::world {
namespace {

using Eigen::VectorXd;

TEST(Body, TakesTheIntegratorThatSuitsItsForces) {
  const auto linear = make_model<double>(test::sample_model().bodies[0]);
  const auto nonlinear = make_model<double>(test::nonlinear_sample_model().bodies[0]);
  EXPECT_EQ(choose({}, linear).name, "exact");
  EXPECT_EQ(choose({}, nonlinear).name, "avf");
  EXPECT_EQ(choose(scene::Integrator::bdf2, linear).name, "bdf2");
}

TEST(Body, InstancesOfOneModelMoveEachAsIfAlone) {
  const auto body = test::nonlinear_sample_model().bodies[0];
  const auto model = std::make_shared<const runtime::Model<double>>(make_model<double>(body));
  const VectorXd rest = VectorXd::Zero(model->size());
  std::vector<Instance<double>> all;
  for (int i = 0; i < 3; ++i) all.push_back(make_instance<double>(model, choose({}, *model), .01, rest));
  auto alone = all[2];
  for (int n = 0; n < 50; ++n)
    for (int i = 0; i < 3; ++i)
      ASSERT_EQ(step<double>(all[i], VectorXd::Constant(model->size(), i + n)).status, runtime::Status::done);
  for (int n = 0; n < 50; ++n) step<double>(alone, VectorXd::Constant(model->size(), 2 + n));
  EXPECT_EQ(all[2].state.history, alone.state.history);
  EXPECT_NE(all[1].state.history, alone.state.history);
  EXPECT_EQ(all[0].model, all[1].model);
}

TEST(Body, AStepThatFailsLeavesTheInstanceAsItWas) {
  const auto body = test::nonlinear_sample_model().bodies[0];
  const auto model = std::make_shared<const runtime::Model<double>>(make_model<double>(body));
  auto instance = make_instance<double>(model, choose({}, *model), .01, VectorXd::Zero(model->size()));
  const auto before = instance;
  EXPECT_NE(step<double>(instance, VectorXd::Constant(model->size(), std::nan(""))).status, runtime::Status::done);
  EXPECT_EQ(instance.state.history, before.state.history);
  EXPECT_EQ(instance.load, before.load);
}

}  // namespace
}  // namespace ritz::world
