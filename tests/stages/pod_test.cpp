// Proper orthogonal decomposition of snapshots against a dense one: whatever their order, on any number of ranks.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "ritz/stages/canonical.hpp"
#include "support/dense_algebra.hpp"
#include "support/reduction.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;
using Eigen::Index;

class Pod : public testing::TestWithParam<const char*> {
 protected:
  const Reduced r = reduced(box_of(std::string("box:1,.4,.3/") + GetParam(), false), 0);
  const Eigen::MatrixXd M = dense(r.p.matrices.mass);

  /// 30 snapshots of rank 12, made from the vertices' file numbers: σ falls by 2 a direction.
  Tall snapshots() const {
    const Tall directions = stages::fixed_vectors(r.p.mesh, r.p.dofs, 12, 9);
    Eigen::MatrixXd mix(12, 30);
    for (Index i = 0; i < mix.size(); ++i) mix(i) = std::sin(1.0 + double(i * i));
    const Eigen::VectorXd fall =
        Eigen::VectorXd::LinSpaced(12, 0, 11).unaryExpr([](double n) { return std::exp2(-n); });
    return 1e-3 * directions * fall.asDiagonal() * mix;
  }
  DenseSvd decomposed(const Tall& x) const {
    const Eigen::MatrixXd L = M.llt().matrixU();
    return dense_svd(L * whole(r.p.mesh.comm, x));
  }
  stages::BasisResult pod(const Tall& x, int size) const {
    return basis_of(r, {.modes = {}, .cut = {.size = size, .tolerance = 1e-12}}, x);
  }
  /// In another order: 7 and their number have no common factor.
  static Tall shuffled(const Tall& x) {
    Tall y(x.rows(), x.cols());
    for (Index j = 0; j < x.cols(); ++j) y.col(j) = x.col((7 * j + 3) % x.cols());
    return y;
  }
};

TEST_P(Pod, FindsTheRankOfSyntheticSnapshots) {
  const Tall x = snapshots();
  const Tall U = pod(x, 0).U;
  EXPECT_EQ(U.cols(), 12);
  Tall rest = x;
  algebra::subtract(rest, U, r.gram(U, x));
  EXPECT_LE(r.norms(rest).maxCoeff(), 1e-12 * r.norms(x).maxCoeff());
}

TEST_P(Pod, IsTheDenseDecompositionInAnyOrderOnAnyRanks) {
  const Tall x = snapshots();
  const auto expected = decomposed(x);
  const Eigen::MatrixXd left = expected.left.leftCols(5), span = M.llt().matrixU().solve(left);
  const double error = expected.values.tail(expected.values.size() - 5).norm(), first = expected.values[0];
  for (const Tall& order : {x, Tall(x.rowwise().reverse()), shuffled(x)}) {
    const auto found = pod(order, 5);
    EXPECT_LE((found.reduction.singular_values - expected.values.head(12)).cwiseAbs().maxCoeff(), 1e-13 * first);
    EXPECT_LE(largest_sine(M, span, whole(r.p.mesh.comm, found.U)), 1e-11);
    EXPECT_NEAR(found.reduction.discarded, error, 1e-12 * first);
    Tall rest = order;
    algebra::subtract(rest, found.U, r.gram(found.U, order));
    EXPECT_NEAR(r.norms(rest).squaredNorm(), error * error, 1e-12 * first * first);
  }
}

// The columns of U too, with their signs: they are turned by K and by vertex numbers, not by the order.
TEST_P(Pod, TheColumnsDoNotDependOnTheOrder) {
  const auto one = pod(snapshots(), 5), other = pod(shuffled(snapshots()), 5);
  EXPECT_LE(r.norms(one.U - other.U).maxCoeff(), 1e-11);
}

INSTANTIATE_TEST_SUITE_P(, Pod, testing::Values("4,2,2/tet4", "3,1,1/tet10", "4,2,2/hex8"), [](const auto& info) {
  const std::string text = info.param;
  return text.substr(text.rfind('/') + 1);
});

}  // namespace
}  // namespace ritz::test
