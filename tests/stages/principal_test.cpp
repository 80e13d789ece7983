// The incremental decomposition against a dense one of everything at once.
#include <gtest/gtest.h>

#include "ritz/stages/canonical.hpp"
#include "support/dense_algebra.hpp"
#include "support/reduction.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;
using Eigen::Index;
using stages::Cut;
using stages::Principal;

class Principals : public testing::TestWithParam<const char*> {
 protected:
  const Problem p = box_of(std::string("box:1,.4,.3/") + GetParam(), false);
  const Eigen::MatrixXd M = dense(p.matrices.mass);

  Tall random(int columns, std::uint64_t stream = 1) const {
    return stages::fixed_vectors(p.mesh, p.dofs, columns, stream);
  }
  /// Random columns whose singular values fall by `factor` a direction.
  Tall graded(int columns, double factor) const {
    const Eigen::ArrayXd n = Eigen::ArrayXd::LinSpaced(columns, 0, columns - 1);
    Eigen::MatrixXd turn(columns, columns);
    for (Index i = 0; i < turn.size(); ++i) turn(i) = std::sin(1.0 + double(i * i));
    return random(columns) * Eigen::ArrayXd::Constant(columns, factor).pow(n).matrix().asDiagonal() * turn;
  }
  Principal add_in_blocks(const Tall& x, Index block, const Cut& cut) const {
    Principal set;
    for (Index j = 0; j < x.cols(); j += block)
      stages::add(p.matrices.mass, set, x.middleCols(j, std::min(block, x.cols() - j)), cut);
    return set;
  }
  DenseSvd svd(const Tall& x) const {
    const Eigen::MatrixXd L = M.llt().matrixU();
    return dense_svd(L * whole(p.mesh.comm, x));
  }
  /// L⁻ᵀ of the first left vectors: M-orthonormal.
  Eigen::MatrixXd directions(const DenseSvd& svd, Index count) const {
    const Eigen::MatrixXd U = svd.left.leftCols(count);
    return M.llt().matrixU().solve(U);
  }
  /// Σ ‖(I − Q QᵀM) x‖²_M
  double projection_error(const Tall& x, const Tall& Q) const {
    Tall rest = x;
    algebra::subtract(rest, Q, algebra::inner(p.mesh.comm, algebra::multiply(p.matrices.mass, Q), x));
    return algebra::inner(p.mesh.comm, rest, algebra::multiply(p.matrices.mass, rest)).trace();
  }
};

TEST_P(Principals, OneBlockIsADenseDecomposition) {
  const Tall x = graded(20, .5);
  const auto expected = svd(x);
  const Principal set = add_in_blocks(x, 20, {});
  ASSERT_EQ(set.sigma.size(), 20);
  const double first = expected.values[0];
  EXPECT_LE((set.sigma - expected.values).cwiseAbs().maxCoeff(), 1e-13 * first);
  EXPECT_LE(largest_sine(M, directions(expected, 6), whole(p.mesh.comm, set.Q.leftCols(6))), 1e-11);
  EXPECT_LE(set.discarded, 1e-26 * first * first);  // rounding alone
}

TEST_P(Principals, ManyBlocksAgreeToWhatTheyDiscard) {
  const Tall x = graded(40, .6);
  const auto expected = svd(x);
  const Cut cut{.size = 8};
  for (const Index block : {1, 7, 40}) {
    const Principal set = add_in_blocks(x, block, cut);
    EXPECT_LT(set.sigma.size(), 40) << "something is dropped";
    EXPECT_GT(set.discarded, 0);
    EXPECT_LE((set.sigma.head(8) - expected.values.head(8)).cwiseAbs().maxCoeff(), std::sqrt(set.discarded));
    EXPECT_LE(projection_error(x, set.Q), set.discarded * (1 + 1e-9)) << block;
    // The trace is kept: what stands and what went make up the whole.
    const double all = expected.values.squaredNorm();
    EXPECT_NEAR((set.sigma.squaredNorm() + set.discarded) / all, 1, 1e-13);
    const Index n = set.sigma.size();
    const Eigen::MatrixXd Q = whole(p.mesh.comm, set.Q);
    EXPECT_LE((Q.transpose() * M * Q - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST_P(Principals, DiscardedSquaresAreTheProjectionError) {
  const Tall x = graded(20, .7);
  const Principal set = add_in_blocks(x, 20, {});
  for (const Index r : {1, 5, 12}) {
    const double error = projection_error(x, set.Q.leftCols(r)), squares = set.sigma.tail(20 - r).squaredNorm();
    EXPECT_NEAR(error, squares, 1e-12 * set.sigma.squaredNorm());
  }
}

TEST_P(Principals, DependentColumnsAddNothing) {
  const Tall few = random(4);
  Tall x(few.rows(), 14);
  x << few, 0 * few.col(0), few * Eigen::MatrixXd::Constant(4, 4, 3), few.rowwise().sum() * 1e-200, few * 1e6;
  for (const Index block : {1, 3, 14}) {
    const Principal set = add_in_blocks(x, block, {});
    EXPECT_EQ(set.sigma.size(), 4) << block;
    EXPECT_TRUE(set.Q.allFinite() && set.sigma.allFinite());
    EXPECT_LE(projection_error(x, set.Q), 1e-24 * set.sigma.squaredNorm());
  }
}

TEST_P(Principals, TheOrderOfColumnsDoesNotMatter) {
  const Tall x = graded(24, .5);
  const Principal one = add_in_blocks(x, 5, {.size = 6}), other = add_in_blocks(x.rowwise().reverse(), 5, {.size = 6});
  const Eigen::MatrixXd a = whole(p.mesh.comm, one.Q.leftCols(6)), b = whole(p.mesh.comm, other.Q.leftCols(6));
  // A direction of σ₆ is turned by what was dropped, in the square at most.
  EXPECT_LE(largest_sine(M, a, b), 10 * std::max(one.discarded, other.discarded) / std::pow(one.sigma[5], 2));
}

TEST_P(Principals, ACutByToleranceKeepsWhatIsAboveIt) {
  const Principal set = add_in_blocks(graded(12, .1), 4, {.tolerance = 1e-4});
  const int kept = stages::kept(set, {.tolerance = 1e-4});
  EXPECT_GT(set.sigma[kept - 1], 1e-4 * set.sigma[0]);
  EXPECT_LE(set.sigma[kept], 1e-4 * set.sigma[0]);
  EXPECT_LT(set.sigma.size(), 12);
}

INSTANTIATE_TEST_SUITE_P(, Principals, testing::Values("4,2,2/tet4", "3,1,1/tet10", "4,2,2/hex8"),
                         [](const auto& info) {
                           const std::string text = info.param;
                           return text.substr(text.rfind('/') + 1);
                         });

}  // namespace
}  // namespace ritz::test
