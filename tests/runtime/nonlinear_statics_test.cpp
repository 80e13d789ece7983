#include "ritz/runtime/statics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/sample_polynomial.hpp"

namespace ritz::runtime {
namespace {

using Eigen::VectorXd;

/// Uniaxial strain of StVK with modulus 1: P = ½ λ (λ² − 1), λ = 1 + z. Its limit point under pressure is at 1/√3.
model::Polynomial bar() { return {1, VectorXd::Constant(1, 1), VectorXd::Constant(1, 3), VectorXd::Constant(1, 3)}; }

TEST(NonlinearStatics, AreTheClosedFormOfABar) {
  const auto model = make_model<double>(bar(), {});
  auto workspace = make_static_workspace(model);
  for (const double stretch : {0.6, 0.75, 1.1, 1.6, 2.0}) {
    VectorXd z = VectorXd::Zero(1);
    const VectorXd none = z, load = VectorXd::Constant(1, 0.5 * stretch * (stretch * stretch - 1));
    solve_static<double>(model, {none, load}, z, workspace);
    EXPECT_NEAR(1 + z[0], stretch, 1e-12 * stretch);
  }
}

TEST(NonlinearStatics, NameTheLimitPoint) {
  const auto model = make_model<double>(bar(), {});
  auto workspace = make_static_workspace(model);
  const double limit = 1 / std::sqrt(27.0);  // ½ λ (1 − λ²) at λ = 1/√3
  VectorXd z = VectorXd::Zero(1);
  const VectorXd none = z, load = VectorXd::Constant(1, -2 * limit);
  const auto outcome = solve_static<double>(model, {none, load}, z, workspace);
  EXPECT_EQ(outcome.failure, NoRest::limit_point);
  EXPECT_NEAR(outcome.reached, .5, 1e-4);
  EXPECT_GT(outcome.softest, 0);
  EXPECT_LT(outcome.softest, .02 * workspace.softest_at_rest);
  EXPECT_NEAR(1 + z[0], 1 / std::sqrt(3.0), 1e-2);
}

TEST(NonlinearStatics, CallNothingElseALimitPoint) {
  const auto model = make_model<double>(bar(), {});
  auto workspace = make_static_workspace(model, {.iterations = 1, .halvings = 0});
  VectorXd z = VectorXd::Constant(1, -.38);  // where the tangent has 8 % of its stiffness left
  const double stretch = 1 + z[0];
  const VectorXd begin = VectorXd::Constant(1, .5 * stretch * (stretch * stretch - 1)), end = 1.0001 * begin;
  EXPECT_EQ(solve_static<double>(model, {begin, end}, z, workspace).failure, NoRest::not_converged);
}

TEST(NonlinearStatics, HalveTheIncrementsAndCountThem) {
  const auto model = make_model<double>(test::random_polynomial(5), {});
  auto workspace = make_static_workspace(model, {.iterations = 4, .halvings = 16});
  auto patient = make_static_workspace(model);
  VectorXd z = VectorXd::Zero(5), same = z;
  const VectorXd none = z, load = 40 * VectorXd::LinSpaced(5, 1, 2);
  const auto outcome = solve_static<double>(model, {none, load}, z, workspace);
  EXPECT_GT(outcome.rejected, 0);
  auto at = make_evaluation(model.force);
  evaluate(model.force, z, at);
  EXPECT_LE((at.force - load).norm(), 1e-10 * load.norm());
  for (int n = 0; n < 100; ++n) {
    const VectorXd begin = n / 100.0 * load, end = (n + 1) / 100.0 * load;
    solve_static<double>(model, {begin, end}, same, patient);
  }
  EXPECT_LE((same - z).norm(), 1e-9 * z.norm());
}

TEST(NonlinearStatics, InSinglePrecision) {
  const auto model = make_model<float>(bar(), {});
  auto workspace = make_static_workspace(model, {.halvings = 16});
  Vector<float> z = Vector<float>::Zero(1);
  const Vector<float> none = z, load = Vector<float>::Constant(1, 3.f);
  solve_static<float>(model, {none, load}, z, workspace);
  EXPECT_NEAR(z[0], 1, 1e-5);
}

TEST(NonlinearStatics, RefuseAFreeBodyAndWhatIsNotFinite) {
  const auto free_body = make_model<double>(test::duffing(0, 1), {});
  auto room = make_static_workspace(free_body);
  VectorXd z = VectorXd::Zero(1);
  const VectorXd none = z, some = VectorXd::Ones(1);
  EXPECT_EQ(solve_static<double>(free_body, {none, some}, z, room).failure, NoRest::free_body);
  const auto model = make_model<double>(bar(), {});
  auto workspace = make_static_workspace(model);
  const VectorXd load = VectorXd::Constant(1, std::numeric_limits<double>::infinity());
  EXPECT_EQ(solve_static<double>(model, {none, load}, z, workspace).failure, NoRest::not_finite);
  EXPECT_EQ(z, none);
}

}  // namespace
}  // namespace ritz::runtime
