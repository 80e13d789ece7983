// Repeated eigenvalues: never cut at k, and the same space whoever computed it.
#include <gtest/gtest.h>

#include "support/dense_algebra.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

const char* const square_beam = "box:1,.1,.1/10,2,2/hex8";

Problem clamped() { return problem(box(square_beam), {fixed("xmin")}); }

TEST(Clusters, AreNotCutAtK) {
  const Problem p = clamped();
  for (const auto& [asked, given] : {std::pair{1, 2}, {2, 2}, {3, 4}, {4, 4}, {5, 5}}) {
    const Eigen::VectorXd lambda = flexible(modes(p, asked).modes);
    EXPECT_EQ(lambda.size(), given) << "k = " << asked;
    EXPECT_LE(lambda[1] / lambda[0] - 1, 1e-9);
  }
}

TEST(Clusters, OfTheCubeAreWhole) {
  const Problem p = problem(box("box:1,1,1/3,3,3/hex8"), {});
  const Eigen::VectorXd all = flexible(modes(p, 17).modes);
  std::vector<int> ends;  // how many modes there are up to the end of each cluster
  for (int i = 1; i < all.size(); ++i)
    if (all[i] - all[i - 1] > 1e-6 * all[i]) ends.push_back(i);
  ASSERT_GE(ends.size(), 4u);
  for (const int k : {1, 3, 4, 6, 7}) {
    const auto end = *std::lower_bound(ends.begin(), ends.end(), k);
    EXPECT_EQ(flexible(modes(p, k).modes).size(), end) << "k = " << k;
  }
}

TEST(Clusters, SpanTheDenseSolversSpaces) {
  const Problem p = clamped();
  const auto result = modes(p, 8);
  const Eigen::MatrixXd M = dense(p.matrices.mass), ours = whole(p.mesh.comm, result.vectors);
  const Eigen::MatrixXd expected = dense_modes(p).vectors;
  const Eigen::VectorXd lambda = flexible(result.modes);
  for (Eigen::Index i = 0, end = 0; i < lambda.size(); i = end) {
    for (end = i + 1; end < lambda.size() && lambda[end] - lambda[end - 1] <= 1e-6 * lambda[end];) ++end;
    EXPECT_LE(largest_sine(M, ours.middleCols(i, end - i), expected.middleCols(i, end - i)), 1e-6)
        << "modes " << i + 1 << " to " << end;
  }
}

TEST(Clusters, SpanTheSameSpaceByAnotherSolver) {
  const Problem p = clamped();
  stages::ModesOptions slepc;
  slepc.count = 3;
  slepc.slepc = true;
  const auto a = modes(p, 3), b = modes(p, slepc);
  ASSERT_EQ(a.vectors.cols(), 4);
  ASSERT_EQ(b.vectors.cols(), 4);
  const Eigen::MatrixXd M = dense(p.matrices.mass), x = whole(p.mesh.comm, a.vectors),
                        y = whole(p.mesh.comm, b.vectors);
  for (const int first : {0, 2}) {
    EXPECT_LE(largest_sine(M, x.middleCols(first, 2), y.middleCols(first, 2)), 1e-6);
    // The basis within a cluster is fixed by the vertices' numbers, not by the solver.
    EXPECT_LE((x - y).middleCols(first, 2).norm(), 1e-6 * x.middleCols(first, 2).norm());
  }
}

}  // namespace
}  // namespace ritz::test
