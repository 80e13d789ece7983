// The basis: what it holds, and how well it carries the full model's statics.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "ritz/base/error.hpp"
#include "ritz/runtime/nonlinear_statics.hpp"
#include "ritz/stages/fixed_vectors.hpp"
#include "ritz/stages/reduce_polynomial.hpp"
#include "support/dense_algebra.hpp"
#include "support/reduction.hpp"

namespace ritz::test {
namespace {

using Eigen::Index;
using petsc::Tall;
using stages::BasisOptions;

void expect_orthonormal_and_diagonal(const Reduced& r, const stages::BasisResult& b) {
  const Index n = b.U.cols();
  EXPECT_LE((r.gram(b.U, b.U) - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::VectorXd& k = b.reduction.stiffness;
  ASSERT_EQ(k.size(), n);
  EXPECT_TRUE(std::is_sorted(k.begin(), k.end()));
  const Eigen::MatrixXd K = petsc::inner(r.p.mesh.comm, b.U, petsc::multiply(r.p.full.stiffness, b.U));
  EXPECT_LE((K - Eigen::MatrixXd(k.asDiagonal())).cwiseAbs().maxCoeff(), 1e-12 * k[n - 1]);
  if (r.rigid.cols() > 0) {
    EXPECT_LE(r.gram(r.rigid, b.U).cwiseAbs().maxCoeff(), 1e-12);
  }
}

/// ‖(I − U UᵀM) x‖_M of each column.
Eigen::VectorXd left_out(const Reduced& r, const Tall& U, Tall x) {
  petsc::subtract(x, U, r.gram(U, x));
  return r.norms(x);
}

class Bases : public testing::TestWithParam<bool> {
 protected:
  const Reduced r = reduced(box_of("box:1,.3,.2/5,2,2/hex8", GetParam()), 6);
};

TEST_P(Bases, AreOrthonormalWithADiagonalStiffness) {
  for (const int size : {0, 1, 8, 14})
    expect_orthonormal_and_diagonal(
        r, basis_of(r, {.modes = {}, .derivatives = 5, .cut = {.size = size, .tolerance = 1e-12}}));
}

// A block that goes is bounded by what is said of it: no scaled column is further from U than that.
TEST_P(Bases, LeaveOutNoMoreThanTheySay) {
  const auto all = all_derivatives(r);
  const Eigen::VectorXd lambda = r.lambda();
  Tall set(all.columns.rows(), lambda.size() + all.columns.cols());
  set.leftCols(lambda.size()) = r.flexible * (lambda[0] / lambda.array()).matrix().asDiagonal();
  for (Index p = 0; p < all.columns.cols(); ++p) {
    const auto [i, j] = all.pairs[static_cast<std::size_t>(p)];
    set.col(lambda.size() + p) = lambda[0] * lambda[0] / (lambda[i] * lambda[j]) * all.columns.col(p);
  }
  const int count = static_cast<int>(lambda.size());
  for (const int block : {8, 1000}) {
    const auto b =
        basis_of(r, {.modes = {}, .derivatives = count, .cut = {.size = 9, .tolerance = 1e-12}, .block = block});
    EXPECT_LE(left_out(r, b.U, set).norm(), b.reduction.discarded * (1 + 1e-6)) << block;
    // ... nor is it a loose bound: what the best 9 directions leave out is all but attained.
    const Eigen::VectorXd squares = symmetric_eigenvalues(r.gram(set, set));
    const double best = std::sqrt(squares.head(squares.size() - 9).sum());
    EXPECT_LE(left_out(r, b.U, set).norm(), 1.01 * best) << block;
    EXPECT_LE(b.reduction.discarded, 1.05 * best) << block;
  }
}

TEST_P(Bases, DependentSnapshotsAreFoundOut) {
  Tall snapshots(r.p.dofs.owned, 6);
  snapshots << r.flexible.leftCols(3), r.flexible.leftCols(3) * Eigen::Matrix3d::Constant(2);
  Reduced none = reduced(box_of("box:1,.3,.2/5,2,2/hex8", GetParam()), 0);
  const auto b = basis_of(none, {}, snapshots);
  EXPECT_EQ(b.U.cols(), 3);
  expect_orthonormal_and_diagonal(none, b);
  EXPECT_LE(left_out(none, b.U, snapshots).maxCoeff(), 1e-12);
  try {
    basis_of(none, {.modes = {}, .cut = {.size = 5, .tolerance = 1e-12}}, snapshots);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("only 3 "));
  }
}

INSTANTIATE_TEST_SUITE_P(, Bases, testing::Bool(),
                         [](const auto& info) { return std::string(info.param ? "free" : "clamped"); });

const std::filesystem::path known = std::filesystem::path(RITZ_SHARED) / "verification" / "tet4_cantilever";

/// Dead end loads p EI/L² along −z on a cantilever, against states of the full model computed elsewhere.
class Cantilever : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(known)) GTEST_SKIP() << "the verification data is not here";
  }

  static Reduced cantilever(int modes) {
    mesh::Source source;
    source.mesh = known / "cantilever.inp";
    return reduced(problem(mesh::read(MPI_COMM_WORLD, source), {fixed("clamp")}), modes);
  }

  static Tall truth(const Reduced& r, const std::string& p) {
    std::map<std::int64_t, Eigen::Vector3d> all;
    std::ifstream in(known / ("static_p" + p + "_all_vertices.csv"));
    std::string line;
    std::getline(in, line);
    std::int64_t id = 0;
    char comma = 0;
    for (Eigen::Vector3d u; in >> id >> comma >> u[0] >> comma >> u[1] >> comma >> u[2];) all[id] = u;
    Tall u(3 * r.p.mesh.owned, 1);
    for (int v = 0; v < r.p.mesh.owned; ++v)
      u.block<3, 1>(3 * v, 0) = all.at(r.p.mesh.ids[static_cast<std::size_t>(v)]);
    return mesh::from_vertices(r.p.mesh, r.p.dofs, u);
  }

  static Tall end_load(const Reduced& r, double total) {
    const mesh::Set& tip = *r.p.mesh.find("tip");
    Tall f = Tall::Zero(3 * r.p.mesh.owned, 1);
    for (const int v : tip.vertices)
      if (v < r.p.mesh.owned) f(3 * v + 2, 0) = -total / static_cast<double>(tip.vertices_total);
    return mesh::from_vertices(r.p.mesh, r.p.dofs, f);
  }

  /// Relative M-norm errors of the reduced statics on U at p = .5, 2, 8.
  static std::vector<double> errors(const Reduced& r, const Tall& U) {
    const auto polynomial =
        stages::reduce_polynomial(r.p.mesh, r.p.full.materials, mesh::to_vertices(r.p.mesh, r.p.dofs, U));
    const auto model = runtime::make_nonlinear_model<double>(polynomial, {});
    auto room = runtime::make_static_workspace(model);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(U.cols()), last = z;
    std::vector<double> found;
    for (const char* p : {"0.5", "2", "8"}) {
      const Eigen::VectorXd load = petsc::inner(r.p.mesh.comm, U, end_load(r, 1.8 * std::stod(p)));
      runtime::solve_static<double>(model, {.begin = last, .end = load}, z, room);
      last = load;
      const Tall u = truth(r, p);
      found.push_back(r.norms(U * z - u)[0] / r.norms(u)[0]);
    }
    return found;
  }

  static void expect_errors(const Reduced& r, const Tall& U, const std::vector<double>& expected) {
    const auto found = errors(r, U);
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i] / expected[i], 1, .2) << found[i];
  }
};

TEST_F(Cantilever, ModesAloneLock) {
  const Reduced r = cantilever(6);
  expect_errors(r, r.flexible.leftCols(6), {.672, .835, .886});
}

TEST_F(Cantilever, DerivativesUnlockIt) {
  const Reduced r = cantilever(4);
  const auto b = basis_of(r, {.modes = {}, .derivatives = 4, .cut = {}});
  EXPECT_EQ(b.U.cols(), 14);
  expect_errors(r, b.U, {3.6e-3, 3.4e-3, 1.8e-2});
}

TEST_F(Cantilever, EightAndTwelveOfEq18) {
  const Reduced r = cantilever(6);
  expect_errors(r, basis_of(r, {.modes = {}, .derivatives = 6, .cut = {.size = 8, .tolerance = 1e-12}}).U,
                {3.6e-3, 3.4e-3, 2.4e-2});
  expect_errors(r, basis_of(r, {.modes = {}, .derivatives = 6, .cut = {.size = 12, .tolerance = 1e-12}}).U,
                {1.1e-3, 1.4e-3, 7.2e-3});
}

}  // namespace
}  // namespace ritz::test
