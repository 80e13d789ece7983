// Different ways to the same modes: block Lanczos, SLEPc's Krylov-Schur, multigrid, and Eigen's dense solver.
#include <gmock/gmock.h>

#include "ritz/algebra/matrix.hpp"
#include "ritz/base/error.hpp"
#include "ritz/stages/inverse.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"
#include "support/dense_algebra.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

using stages::ModesOptions;
using stages::Strategy;

void expect_same(const Problem& p, const stages::ModesResult& a, const stages::ModesResult& b, double gate) {
  ASSERT_EQ(a.modes.eigenvalues.size(), b.modes.eigenvalues.size());
  ASSERT_EQ(rigid_count(a.modes), rigid_count(b.modes));
  const Eigen::VectorXd x = flexible(a.modes), y = flexible(b.modes);
  EXPECT_LE((x - y).cwiseQuotient(x).cwiseAbs().maxCoeff(), gate);
  // The span as a whole: the last mode is well apart from the next one in these problems.
  EXPECT_LE(largest_sine(dense(p.matrices.mass), whole(p.mesh.comm, a.vectors), whole(p.mesh.comm, b.vectors)), 1e-6);
}

struct Case {
  const char* mesh;
  bool free;
};

class Strategies : public testing::TestWithParam<Case> {
 protected:
  Problem p = problem(box(GetParam().mesh), GetParam().free ? std::vector<mesh::Fixed>{} : std::vector{fixed("xmin")});
};

TEST_P(Strategies, LanczosFindsWhatADenseSolverFinds) {
  const auto result = modes(p, 12);
  const Eigen::VectorXd all = dense_modes(p).values, lambda = flexible(result.modes);
  const Eigen::VectorXd expected = all.segment(rigid_count(result.modes), lambda.size());
  // A dense solver's own error is of the order of ε times the largest eigenvalue.
  const double floor = 1e-15 * all.tail(1)[0];
  for (Eigen::Index i = 0; i < lambda.size(); ++i)
    EXPECT_NEAR(lambda[i], expected[i], 1e-10 * expected[i] + 10 * floor) << "mode " << i + 1;
}

TEST_P(Strategies, KrylovSchurAgrees) {
  ModesOptions slepc;
  slepc.count = 12;
  slepc.slepc = true;
  expect_same(p, modes(p, 12), modes(p, slepc), 1e-10);
}

TEST_P(Strategies, KrylovSchurLeavesAnInverseToTheDerivatives) {
  ModesOptions slepc;
  slepc.count = 6;
  slepc.slepc = true;
  slepc.inverse = stages::InverseUse::kept;
  const auto found = modes(p, slepc);
  const algebra::Tall psi = found.vectors.rightCols(1), rigid = found.vectors.leftCols(rigid_count(found.modes));
  const algebra::Tall b = algebra::multiply(p.matrices.mass, psi);
  const auto x = stages::solve(p.matrices, found.inverse, rigid, algebra::one_norm(p.matrices.stiffness), b).x;
  const algebra::Tall expected = psi / found.modes.eigenvalues.tail(1)[0];  // Kψ = λMψ
  EXPECT_LE(algebra::column_norms(p.mesh.comm, x - expected)[0],
            1e-7 * algebra::column_norms(p.mesh.comm, expected)[0]);
}

TEST_P(Strategies, MultigridAgrees) {
  ModesOptions iterative;
  iterative.count = 6;
  iterative.strategy = Strategy::iterative;
  expect_same(p, modes(p, 6), modes(p, iterative), 1e-8);
}

TEST_P(Strategies, EarlierModesSpareWorkAndChangeNothing) {
  const auto first = modes(p, 12);
  ModesOptions options;
  options.count = 12;
  const algebra::Tall earlier = first.vectors.rightCols(flexible(first.modes).size());
  const auto again =
      stages::linear_modes(p, options, earlier, algebra::Tall(p.dofs.owned, 0), [](const std::string&, double) {});
  expect_sound(p, options, again);
  expect_same(p, first, again, 1e-10);
  EXPECT_LT(again.iterations, first.iterations);
}

TEST(Residuals, AboveTheirGateSayWhatKeptThemThere) {
  const Problem p = problem(box("box:1,.1,.06/8,2,1/tet4"), {fixed("xmin")});
  const algebra::Tall none(p.dofs.owned, 0);
  ModesOptions loose;
  loose.count = 12;
  loose.tolerance = 1e-2;
  try {
    stages::linear_modes(p, loose, none, none, [](const std::string&, double) {});
    ADD_FAILURE() << "the gate let them pass";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("above its gate"));
    EXPECT_EQ(error.reason, Reason::tolerance_too_loose);
  }
}

INSTANTIATE_TEST_SUITE_P(, Strategies,
                         testing::Values(Case{"box:1,.1,.06/8,2,1/tet4", false}, Case{"box:1,.1,.06/8,2,1/tet4", true},
                                         Case{"box:1,.1,.06/4,1,1/tet10", false},
                                         Case{"box:.4,.3,.2/4,3,2/hex8", false}, Case{"box:.4,.3,.2/4,3,2/hex8", true}),
                         [](const auto& info) {
                           const std::string text = info.param.mesh;
                           return text.substr(text.rfind('/') + 1) + (info.param.free ? "_free" : "_clamped");
                         });

}  // namespace
}  // namespace ritz::test
