// The basis: what it holds, and what it leaves out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "ritz/base/error.hpp"
#include "ritz/stages/canonical.hpp"
#include "support/dense_algebra.hpp"
#include "support/reduction.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;
using Eigen::Index;
using stages::BasisOptions;

void expect_orthonormal_and_diagonal(const Reduced& r, const stages::BasisResult& b) {
  const Index n = b.U.cols();
  EXPECT_LE((r.gram(b.U, b.U) - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::VectorXd& k = b.reduction.stiffness;
  ASSERT_EQ(k.size(), n);
  EXPECT_TRUE(std::is_sorted(k.begin(), k.end()));
  const Eigen::MatrixXd K = algebra::inner(r.p.mesh.comm, b.U, algebra::multiply(r.p.matrices.stiffness, b.U));
  EXPECT_LE((K - Eigen::MatrixXd(k.asDiagonal())).cwiseAbs().maxCoeff(), 1e-12 * k[n - 1]);
  if (r.rigid.cols() > 0) {
    EXPECT_LE(r.gram(r.rigid, b.U).cwiseAbs().maxCoeff(), 1e-12);
  }
}

/// ‖(I − U UᵀM) x‖_M of each column.
Eigen::VectorXd left_out(const Reduced& r, const Tall& U, Tall x) {
  algebra::subtract(x, U, r.gram(U, x));
  return r.norms(x);
}

class Bases : public testing::TestWithParam<std::tuple<const char*, bool>> {
 protected:
  static Problem body() {
    const auto& [cells, free] = GetParam();
    return box_of(std::string("box:1,.3,.2/") + cells, free);
  }

  const Reduced r = reduced(body(), 6);
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
  for (const double tolerance : {1e-1, 1e-2}) {
    const auto b = basis_of(r, {.modes = {}, .derivatives = count, .cut = {.size = 0, .tolerance = tolerance}});
    const auto& sigma = b.reduction.singular_values;
    const Index kept = b.U.cols();
    EXPECT_GT(sigma[kept - 1], tolerance * sigma[0]) << tolerance;
    if (kept < sigma.size()) {
      EXPECT_LE(sigma[kept], tolerance * sigma[0]) << tolerance;
    }
    EXPECT_LT(kept, set.cols()) << tolerance;
    EXPECT_LE(left_out(r, b.U, set).norm(), b.reduction.discarded * (1 + 1e-6)) << tolerance;
  }
}

TEST_P(Bases, DependentSnapshotsAreFoundOut) {
  Tall snapshots(r.p.dofs.owned, 6);
  snapshots << r.flexible.leftCols(3), r.flexible.leftCols(3) * Eigen::Matrix3d::Constant(2);
  Reduced none = reduced(body(), 0);
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

TEST_P(Bases, SnapshotsJoinTheModesWhateverTheirSize) {
  Tall x = stages::fixed_vectors(r.p.mesh, r.p.dofs, 3, 9);
  if (r.rigid.cols() > 0) algebra::subtract(x, r.rigid, r.gram(r.rigid, x));
  for (const double scale : {1e-6, 1., 1e6}) {
    const auto b = basis_of(r, {}, scale * x);
    EXPECT_EQ(b.U.cols(), r.flexible.cols() + 3);
    expect_orthonormal_and_diagonal(r, b);
    EXPECT_LE(left_out(r, b.U, r.flexible).maxCoeff(), 1e-12);
    EXPECT_LE(left_out(r, b.U, x).maxCoeff(), 1e-12 * r.norms(x).maxCoeff());
  }
}

INSTANTIATE_TEST_SUITE_P(, Bases,
                         testing::Combine(testing::Values("5,2,2/tet4", "3,1,1/tet10", "5,2,2/hex8"), testing::Bool()),
                         [](const auto& info) {
                           const std::string text = std::get<0>(info.param);
                           return text.substr(text.rfind('/') + 1) + (std::get<1>(info.param) ? "_free" : "_clamped");
                         });

// Equal bending modes of a square beam: derivatives of the first are derivatives of both.
TEST(Basis, DerivativesNeverCutACluster) {
  const Reduced r = reduced(box_of("box:1,.2,.2/5,1,1/hex8", false), 4);
  ASSERT_LE(r.lambda()[1] - r.lambda()[0], 1e-6 * r.lambda()[1]);
  const auto pairs = [&](int derivatives) {
    return basis_of(r, {.modes = {}, .derivatives = derivatives, .cut = {}}).derivatives.pairs;
  };
  EXPECT_EQ(pairs(1), 3);
  EXPECT_EQ(pairs(2), 3);
  EXPECT_EQ(basis_of(r, {.modes = {}, .derivatives = 1, .cut = {}}).U.cols(), r.flexible.cols() + 3);
}

/// The same beam in metres and kilograms, and as if its numbers in millimetres and tonnes were those.
TEST(Basis, UnitsMoveATruncatedSpanAlone) {
  const auto beam = [](const std::string& box_text, const fem::Material& material) {
    return reduced(problem(box(box_text), {fixed("xmin")}, {material}), 6);
  };
  const Reduced si = beam("box:1,.2,.15/5,2,2/hex8", test::stvk(1e6, .3, 1000));
  const Reduced mm = beam("box:1000,200,150/5,2,2/hex8", test::stvk(1, .3, 1e-9));
  const auto sine = [&](int size) {
    const stages::BasisOptions options{.modes = {}, .derivatives = 6, .cut = {.size = size, .tolerance = 1e-12}};
    const Tall U = basis_of(si, options).U, V = basis_of(mm, options).U / std::sqrt(1000.);  // 1 t = 1000 kg
    EXPECT_EQ(U.cols(), V.cols());
    return largest_sine(dense(si.p.matrices.mass), whole(MPI_COMM_WORLD, U), whole(MPI_COMM_WORLD, V));
  };
  EXPECT_LE(sine(0), 1e-8);
  EXPECT_GT(sine(8), .5);
}

}  // namespace
}  // namespace ritz::test
