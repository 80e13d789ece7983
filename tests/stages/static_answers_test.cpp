// Static answers and residual vectors: what they solve, that a basis with them is exact, and what is missed without.
#include "ritz/stages/static_answers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ritz/algebra/matrix.hpp"
#include "support/reduction.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;
using Eigen::Index;
using stages::LoadPlace;

const std::vector<LoadPlace> places = {"xmin", "xmax", "zmax", std::nullopt};

/// Whether the body is held, and how K is solved with.
struct Way {
  const char* name;
  bool free;
  stages::Strategy strategy;
};

class StaticAnswers : public testing::TestWithParam<Way> {
 protected:
  Tall answers(const Tall& b) const {
    return stages::static_answers(r.p.matrices, r.modes.inverse, r.rigid, algebra::one_norm(r.p.matrices.stiffness), b);
  }
  Tall K(const Tall& x) const { return algebra::multiply(r.p.matrices.stiffness, x); }
  Eigen::MatrixXd stiffness(const Tall& x) const { return algebra::inner(r.p.mesh.comm, x, K(x)); }
  /// What inertia leaves of loads.
  Tall relieved(Tall b) const {
    if (r.rigid.cols() > 0)
      algebra::subtract(b, algebra::multiply(r.p.matrices.mass, r.rigid), algebra::inner(r.p.mesh.comm, r.rigid, b));
    return b;
  }
  /// The answers of a basis whose UᵀKU is `k`.
  Tall answers_of(const Tall& U, const Eigen::VectorXd& k, const Tall& b) const {
    const Eigen::VectorXd inverse = k.unaryExpr([](double value) { return value > 0 ? 1 / value : 0; });
    return algebra::combine(U, inverse.asDiagonal() * algebra::inner(r.p.mesh.comm, U, b));
  }
  Eigen::VectorXd sizes(const Tall& x) const { return stiffness(x).diagonal().cwiseMax(0).cwiseSqrt(); }
  void expect_exact(const Tall& U, const Eigen::VectorXd& k) const {
    const Tall missed = answers_of(U, k, loads.columns) - w;
    EXPECT_LE(sizes(missed).maxCoeff(), 1e-8 * sizes(w).maxCoeff());
    EXPECT_LE(r.norms(missed).maxCoeff(), 1e-8 * r.norms(w).maxCoeff());
    for (const auto& error : stages::static_errors(r.p, U, k, loads, w)) EXPECT_LE(error.missing, 1e-7);
  }

  const Reduced r = reduced(box_of("box:1,.3,.2/5,2,2/tet4", GetParam().free, true), 6, GetParam().strategy);
  const stages::UnitLoads loads = stages::unit_loads(r.p, places);
  const Tall w = answers(loads.columns);
};

TEST_P(StaticAnswers, BalanceTheLoads) {
  const Tall b = relieved(loads.columns);
  const Eigen::VectorXd size = algebra::column_norms(r.p.mesh.comm, loads.columns);
  EXPECT_LE(algebra::column_norms(r.p.mesh.comm, K(w) - b).maxCoeff(), 1e-9 * size.maxCoeff());
  if (r.rigid.cols() > 0) {
    EXPECT_LE(r.gram(r.rigid, w).cwiseAbs().maxCoeff(), 1e-12 * r.norms(w).maxCoeff());
  }
  // Supports bear what acts on them; the inertia of a free fall bears gravity.
  EXPECT_TRUE((w.middleCols(GetParam().free ? 9 : 0, 3).array() == 0).all());
  EXPECT_GT(r.norms(w.middleCols(3, 6)).minCoeff(), 0);
}

TEST_P(StaticAnswers, AreSolvedForBesideTheModes) {
  stages::ModesOptions options;
  options.strategy = GetParam().strategy;
  for (const int count : {0, 6}) {
    options.count = count;
    const auto found =
        stages::linear_modes(r.p, options, Tall(r.p.dofs.owned, 0), loads.columns, [](const std::string&, double) {});
    EXPECT_LE(r.norms(found.answers - w).maxCoeff(), 1e-7 * r.norms(w).maxCoeff()) << count;
    EXPECT_EQ(bool(found.inverse), false);
  }
}

TEST_P(StaticAnswers, ResidualVectorsMakeModesExact) {
  const auto residual = stages::residual_vectors(r.p, r.modes.vectors, w);
  const Index count = residual.values.size();
  EXPECT_EQ(count, 9);  // of three places, three axes each
  EXPECT_LE(r.gram(r.modes.vectors, residual.vectors).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GE(residual.values.minCoeff(), r.lambda()[5]);
  const auto joined = stages::joined_basis(r.p, r.modes, residual);
  const Index all = r.modes.vectors.cols() + count;
  EXPECT_EQ(joined.reduction.residual_vectors, count);
  EXPECT_LE((r.gram(joined.U, joined.U) - Eigen::MatrixXd::Identity(all, all)).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::VectorXd& k = joined.reduction.stiffness;
  EXPECT_TRUE(std::is_sorted(k.begin(), k.end()));
  const Eigen::MatrixXd error = stiffness(joined.U) - Eigen::MatrixXd(k.asDiagonal());
  EXPECT_LE(error.cwiseAbs().maxCoeff(), 1e-10 * k[all - 1]);
  EXPECT_EQ(joined.U.leftCols(r.modes.vectors.cols()), r.modes.vectors);  // the modes, as they are
  expect_exact(joined.U, k);
}

TEST_P(StaticAnswers, ResidualVectorsSurviveTheCutOfABasis) {
  const Tall given = stages::residual_vectors(r.p, r.rigid, w).vectors;
  const auto basis =
      stages::basis(r.p, r.modes, Tall(r.p.dofs.owned, 0), given, {.modes = {}, .derivatives = 3, .cut = {.size = 4}},
                    [](const std::string&, double) {});
  EXPECT_EQ(basis.U.cols(), 4 + given.cols());
  EXPECT_EQ(basis.reduction.residual_vectors, given.cols());
  EXPECT_EQ(basis.reduction.kept(), 4);
  expect_exact(basis.U, basis.reduction.stiffness);
}

TEST_P(StaticAnswers, DependentOnesAreDropped) {
  Tall twice(w.rows(), 2 * w.cols());
  twice << w, w * Eigen::MatrixXd::Constant(w.cols(), w.cols(), 2);
  const auto once = stages::residual_vectors(r.p, r.modes.vectors, w);
  EXPECT_EQ(stages::residual_vectors(r.p, r.modes.vectors, twice).values.size(), once.values.size());
  const Tall known = answers(algebra::multiply(r.p.matrices.mass, r.flexible));  // ψ/λ: in the modes' span
  EXPECT_EQ(stages::residual_vectors(r.p, r.modes.vectors, known).values.size(), 0);
}

// Modes are K-orthogonal, so that each takes (ψᵀb)²/λ of bᵀw.
TEST_P(StaticAnswers, WhatModesMissIsTheRestOfTheirSum) {
  const auto errors = stages::static_errors(r.p, r.modes.vectors, r.modes.modes.eigenvalues, loads, w);
  EXPECT_EQ(errors.size(), 9U);
  for (const auto& error : errors) {
    const auto place = std::find(places.begin(), places.end(), error.place) - places.begin();
    const Tall b = loads.columns.col(3 * place + error.axis);
    const Eigen::ArrayXd part = algebra::inner(r.p.mesh.comm, r.flexible, b).array();
    const double all = algebra::inner(r.p.mesh.comm, b, w.col(3 * place + error.axis))(0, 0);
    EXPECT_NEAR(error.missing * error.missing, 1 - (part.square() / r.lambda().array()).sum() / all, 1e-8);
    EXPECT_GT(error.missing, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(, StaticAnswers,
                         testing::Values(Way{"held", false, stages::Strategy::direct},
                                         Way{"free", true, stages::Strategy::direct},
                                         Way{"held_iterative", false, stages::Strategy::iterative},
                                         Way{"free_iterative", true, stages::Strategy::iterative}),
                         [](const auto& info) { return info.param.name; });

/// A bar that is pulled: the nth of its modes along x takes 8/π²(2n − 1)² of the energy.
TEST(StaticErrors, OfAPulledBar) {
  const Problem p = problem(box("box:1,.1,.1/60,1,1/hex8"), {fixed("xmin")}, {stvk(1e6, 0, 1000)});
  stages::ModesOptions options;
  options.count = 16;
  const auto loads = stages::unit_loads(p, {"xmax"});
  const auto found =
      stages::linear_modes(p, options, Tall(p.dofs.owned, 0), loads.columns, [](const std::string&, double) {});
  const Eigen::ArrayXd pulled = algebra::inner(p.mesh.comm, found.vectors, loads.columns.col(0)).array().abs();
  double rest = 1;
  int along = 0;
  for (const double part : pulled)
    if (part > 1e-3 * pulled.maxCoeff()) rest -= 8 / std::pow(std::numbers::pi * (2 * along++ + 1), 2);
  ASSERT_GE(along, 2);
  const auto errors = stages::static_errors(p, found.vectors, found.modes.eigenvalues, loads, found.answers);
  EXPECT_NEAR(errors[0].missing, std::sqrt(rest), 2e-3);
}

}  // namespace
}  // namespace ritz::test
