// The smallest basis for an error: what it says of itself, that no smaller one would do, and targets out of reach.
#include "ritz/stages/accurate_basis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ritz/base/error.hpp"
#include "ritz/runtime/statics.hpp"
#include "ritz/stages/canonical.hpp"
#include "ritz/stages/full_statics.hpp"
#include "ritz/stages/reduce_polynomial.hpp"
#include "support/reduction.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;
using Eigen::Index;

/// A cantilever that is bent far, and its equilibria under two loads.
class AccurateBasis : public testing::TestWithParam<const char*> {
 protected:
  stages::StaticPath equilibria(const Tall& load) const {
    auto model = stages::full_model(r.p, algebra::LinearSolver::direct);
    stages::StaticPath path{Tall(r.p.dofs.owned, 2), Tall(r.p.dofs.owned, 2)};
    stages::full_statics(
        model, {.steps = 2}, {0, Tall::Zero(r.p.dofs.owned, 1), 0},
        [&](double fraction) -> Tall { return fraction * load; },
        [&](const stages::StaticState& state, const stages::StaticReport&) {
          const Index level = state.fraction < .75 ? 0 : 1;
          path.loads.col(level) = state.fraction * load;
          path.truth.col(level) = state.u;
        });
    return path;
  }

  Tall tip_load() const {
    Tall f = Tall::Zero(3 * r.p.mesh.owned, 1);
    const mesh::Set& tip = *r.p.mesh.find("xmax");
    for (const int v : tip.vertices)
      if (v < r.p.mesh.owned) f.block<3, 1>(3 * v, 0) = Eigen::Vector3d(0, 1, -2) * 2 / tip.vertices_total;
    return mesh::from_vertices(r.p.mesh, r.p.dofs, f);
  }

  stages::AccurateBasis choose(double target) const { return choose(target, path); }
  stages::AccurateBasis choose(double target, const stages::StaticPath& on) const {
    return stages::accurate_basis(r.p, *stages::polynomial_laws(r.p.materials), r.modes, on, target,
                                  [](const std::string&, double) {});
  }

  /// The error of a basis, from its own polynomial.
  double error(const Tall& U) const {
    const auto model =
        runtime::make_model<double>(stages::reduce_polynomial(r.p, *stages::polynomial_laws(r.p.materials),
                                                              mesh::to_vertices(r.p.mesh, r.p.dofs, U)),
                                    {});
    auto room = runtime::make_static_workspace(model);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(U.cols()), last = z;
    double worst = 0;
    for (Index level = 0; level < 2; ++level) {
      const Eigen::VectorXd load = algebra::inner(r.p.mesh.comm, U, path.loads.col(level));
      if (runtime::solve_static<double>(model, {.begin = last, .end = load}, z, room).failure)
        return std::numeric_limits<double>::infinity();
      last = load;
      worst = std::max(worst, r.norms(U * z - path.truth.col(level))[0] / r.norms(path.truth.col(level))[0]);
    }
    return worst;
  }

  const Reduced r = reduced(box_of(std::string("box:1,.1,.1/") + GetParam(), false), 5);
  const stages::StaticPath path = equilibria(tip_load());
};

TEST_P(AccurateBasis, HasTheErrorThatItSays) {
  for (const double target : {.3, .02}) {
    const auto [basis, chosen] = choose(target);
    EXPECT_EQ(basis.U.cols(), chosen.columns);
    EXPECT_LE(chosen.error, target);
    EXPECT_NEAR(error(basis.U), chosen.error, 1e-6);
  }
}

TEST_P(AccurateBasis, IsTheSmallest) {
  const double target = .02;
  const auto chosen = choose(target).chosen;
  ASSERT_GT(chosen.columns, 1);
  const auto lambda = r.lambda();
  for (int count = 1; count <= 5; ++count) {
    std::vector<int> first(static_cast<std::size_t>(count));
    for (int n = 0; n < count; ++n) first[static_cast<std::size_t>(n)] = n + 1;
    const bool cut_cluster =
        count < lambda.size() && lambda[count] - lambda[count - 1] <= stages::cluster_gap * lambda[count];
    if (cut_cluster) continue;
    for (int columns = 1; columns < std::min(chosen.columns, count + count * (count + 1) / 2 + 1); ++columns)
      EXPECT_GT(error(basis_of(r, {.modes = first, .derivatives = count, .cut = {.size = columns}}).U), target)
          << columns << " columns of " << count << " modes";
  }
}

TEST_P(AccurateBasis, KeepsClustersWhole) {
  const auto chosen = choose(.02).chosen;
  const auto lambda = r.lambda();
  if (chosen.modes > 0 && chosen.modes < lambda.size()) {
    EXPECT_GT(lambda[chosen.modes] - lambda[chosen.modes - 1], stages::cluster_gap * lambda[chosen.modes]);
  }
}

// The path's first term answers a small load, its second the first sign of curvature, whatever modes would.
TEST_P(AccurateBasis, ASmallLoadTakesOneColumnAndALargerOneTwo) {
  const auto one = choose(1e-5, equilibria(1e-6 * tip_load()));
  EXPECT_EQ(one.chosen.columns, 1);
  EXPECT_EQ(one.basis.U.cols(), 1);
  EXPECT_EQ(one.chosen.modes, 0);
  const auto two = choose(1e-4, equilibria(1e-2 * tip_load()));
  EXPECT_EQ(two.chosen.columns, 2);
}

TEST_P(AccurateBasis, SaysWhatWasReachedWhenTheTargetIsNot) {
  try {
    choose(1e-6);
    FAIL();
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.reason, Reason::accuracy_out_of_reach);
    EXPECT_THAT(error.what(), testing::HasSubstr("on the static path"));
  }
}

// Hexahedra: the bending modes come in equal pairs.
INSTANTIATE_TEST_SUITE_P(, AccurateBasis, testing::Values("8,2,2/tet4", "6,1,1/tet10", "8,1,1/hex8"),
                         [](const auto& info) {
                           const std::string text = info.param;
                           return text.substr(text.rfind('/') + 1);
                         });

}  // namespace
}  // namespace ritz::test
