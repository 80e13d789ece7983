// Modal derivatives against the tangent's own differences, and what their bounds let go.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "ritz/mesh/halo.hpp"
#include "ritz/stages/internal_force.hpp"
#include "support/reduction.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;
using Eigen::Index;
using stages::Pair;

struct Case {
  const char* mesh;
  bool free, two;
};

constexpr int modes_wanted = 10;  // more than one register's width of modes

class Derivatives : public testing::TestWithParam<Case> {
 protected:
  const Reduced r =
      reduced(box_of(std::string("box:1,.4,.3/") + GetParam().mesh, GetParam().free, GetParam().two), modes_wanted);
  const int modes = static_cast<int>(r.flexible.cols());
  const MPI_Comm comm = r.p.mesh.comm;

  Tall loads(int first, int last) const {
    const Tall local = mesh::with_ghosts(r.p.mesh, mesh::to_vertices(r.p.mesh, r.p.dofs, r.flexible), mesh::components);
    return stages::derivative_loads(r.p, local, first, last);
  }

  /// −[K(εψ_j) − K(−εψ_j)]/(2ε) ψ_i for all i: K is quadratic, so that this is exact for any ε.
  Tall by_differences(int j) const {
    stages::Tangent tangent = stages::empty_tangent(r.p);
    const Tall psi = mesh::to_vertices(r.p.mesh, r.p.dofs, r.flexible.col(j));
    const double epsilon = 1;
    Tall both(psi.rows(), 2);
    both << epsilon * psi, -epsilon * psi;
    const Eigen::Vector2d weights(-.5 / epsilon, .5 / epsilon);
    stages::fill_tangent(tangent, r.p, weights, both);
    return algebra::multiply(tangent.matrix, r.flexible);
  }

  /// (I − M R Rᵀ) b
  Tall projected(Tall b) const {
    if (r.rigid.cols() > 0)
      algebra::subtract(b, algebra::multiply(r.p.matrices.mass, r.rigid), algebra::inner(comm, r.rigid, b));
    return b;
  }
};

TEST_P(Derivatives, LoadsAreTheTangentsDifferences) {
  const Tall b = loads(0, modes);
  const auto pairs = stages::pairs_of_rows(0, modes, modes);
  ASSERT_EQ(b.cols(), static_cast<Index>(pairs.size()));
  for (int j = 0; j < modes; ++j) {
    const Tall expected = by_differences(j);  // column i is b_ij, and b_ji: both triangles are compared
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      if (pairs[p].i != j && pairs[p].j != j) continue;
      const Tall other = expected.col(pairs[p].i == j ? pairs[p].j : pairs[p].i);
      const double size = algebra::column_norms(comm, other)[0];
      EXPECT_GT(size, 0);
      EXPECT_LE(algebra::column_norms(comm, b.col(static_cast<Index>(p)) - other)[0], 1e-10 * size)
          << pairs[p].i << " " << pairs[p].j;
    }
  }
}

TEST_P(Derivatives, LoadsOfSomeRowsAreThoseOfAll) {
  const Tall all = loads(0, modes), some = loads(2, 4);
  EXPECT_EQ((some - all.middleCols(modes + modes - 1, some.cols())).lpNorm<Eigen::Infinity>(), 0);
}

TEST_P(Derivatives, SolveTheirEquation) {
  const auto all = all_derivatives(r);
  const Tall b = projected(loads(0, modes));
  const Tall rest = algebra::multiply(r.p.matrices.stiffness, all.columns) - b;
  const Eigen::VectorXd errors = algebra::column_norms(comm, rest).cwiseQuotient(algebra::column_norms(comm, b));
  EXPECT_LE(errors.maxCoeff(), 2e-11);
  if (GetParam().free) {
    const Eigen::VectorXd sizes = r.norms(all.columns);
    EXPECT_LE((r.gram(r.rigid, all.columns) * sizes.cwiseInverse().asDiagonal()).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST_P(Derivatives, ComeInBlocks) {
  Index pairs = 0;
  stages::derivatives(
      r.source(), 2, [](Pair) { return 1.0; }, [] { return 0.0; },
      [&](const stages::DerivativeBlock& block) {
        EXPECT_LT(block.columns.cols(), 4) << "a row of pairs is longer";
        EXPECT_EQ(block.columns.cols(), static_cast<Index>(block.pairs.size()));
        pairs += block.columns.cols();
      });
  EXPECT_EQ(pairs, modes * (modes + 1) / 2);
}

// With the fewest directions kept and a low cut, what was not solved really does not matter.
TEST_P(Derivatives, WhatIsSkippedIsSmall) {
  const auto all = all_derivatives(r);
  const Eigen::VectorXd lambda = r.lambda(), sizes = r.norms(all.columns);
  const auto weight = [&](Pair p) { return lambda[0] / lambda[p.i] * (lambda[0] / lambda[p.j]); };
  const double least = .3 * weight({0, 0}) * sizes[0];
  std::size_t next = 0;
  double left_out = 0;
  const auto skip = [&](Pair p) {  // pairs before p that were not handed over
    for (; all.pairs[next].i != p.i || all.pairs[next].j != p.j; ++next) {
      const double size = weight(all.pairs[next]) * sizes[static_cast<Index>(next)];
      EXPECT_LT(size, least);
      left_out += size * size;
    }
    ++next;
  };
  const auto counts = stages::derivatives(
      r.source(), 4, weight, [&] { return least; },
      [&](const stages::DerivativeBlock& block) {
        for (std::size_t n = 0; n < block.pairs.size(); ++n) {
          skip(block.pairs[n]);
          const Tall same = all.columns.col(static_cast<Index>(next - 1));
          EXPECT_LE(r.norms(block.columns.col(static_cast<Index>(n)) - same)[0], 1e-8 * r.norms(same)[0]);
        }
      });
  for (; next < all.pairs.size(); ++next)
    left_out += std::pow(weight(all.pairs[next]) * sizes[static_cast<Index>(next)], 2);
  EXPECT_EQ(counts.pairs, modes * (modes + 1) / 2);
  EXPECT_GT(counts.solved, 0);
  // The bound of a free body, whose first eigenvalue is high, is too far above to skip any of so few.
  EXPECT_LT(counts.solved, counts.pairs + (GetParam().free ? 1 : 0));
  EXPECT_GE(counts.skipped, left_out);
  EXPECT_LT(std::sqrt(counts.skipped), least);
}

INSTANTIATE_TEST_SUITE_P(, Derivatives,
                         testing::Values(Case{"5,2,2/tet4", false, false}, Case{"5,2,2/tet4", true, false},
                                         Case{"3,1,1/tet10", false, true}, Case{"3,1,1/tet10", true, false},
                                         Case{"4,2,2/hex8", false, true}, Case{"4,2,2/hex8", true, false}),
                         [](const auto& info) {
                           const std::string text = info.param.mesh;
                           return text.substr(text.rfind('/') + 1) + (info.param.free ? "_free" : "_clamped");
                         });

class TwoWays : public testing::TestWithParam<std::tuple<const char*, bool>> {};

TEST_P(TwoWays, MultigridAgreesWithAFactorization) {
  const auto& [cells, free] = GetParam();
  const std::string box = std::string("box:1,.4,.3/") + cells;
  const Reduced direct = reduced(box_of(box, free), 4);
  Reduced iterative = reduced(box_of(box, free), 4, stages::Strategy::iterative);
  iterative.flexible = direct.flexible;  // the same modes: what differs is the solve
  const Tall a = all_derivatives(direct).columns, b = all_derivatives(iterative).columns;
  const Eigen::VectorXd errors = direct.norms(a - b).cwiseQuotient(direct.norms(a));
  EXPECT_LE(errors.maxCoeff(), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(, TwoWays,
                         testing::Combine(testing::Values("4,2,2/tet4", "2,1,1/tet10", "4,2,2/hex8", "2,1,1/hex20",
                                                          "3,1,2/wedge6", "2,1,1/wedge15"),
                                          testing::Bool()),
                         [](const auto& info) {
                           const std::string text = std::get<0>(info.param);
                           return text.substr(text.rfind('/') + 1) + (std::get<1>(info.param) ? "_free" : "_clamped");
                         });

}  // namespace
}  // namespace ritz::test
