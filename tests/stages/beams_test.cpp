// The common block, 1 x 0.10 x 0.06 m clamped at x = 0, against beam theory and a fine three-dimensional reference.
#include <gtest/gtest.h>

#include <memory>

#include "ritz/stages/projection.hpp"
#include "support/graded_block.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

enum class Kind { along_x, along_y, along_z, twist };

/// Solved once for all tests.
struct Solution {
  Eigen::VectorXd frequencies;
  std::vector<Kind> kinds;  ///< by the rigid motion that each mode shares most with

  Solution() {
    const Problem p = problem(graded_block(32, 6, 4), {fixed("xmin")});
    const auto result = modes(p, 26);
    frequencies = test::frequencies(result.modes);
    const auto inertia =
        stages::inertia(p.mesh, p.matrices.scalar_mass, mesh::to_vertices(p.mesh, p.dofs, result.vectors));
    const Eigen::MatrixXd coupling = inertia.rigid_coupling();
    Eigen::MatrixXd shares(coupling.rows(), 4);
    shares << coupling.leftCols(3).cwiseAbs2() / inertia.mass(), coupling.col(3).cwiseAbs2() / inertia.tensor()(0, 0);
    for (Eigen::Index i = 0; i < shares.rows(); ++i) {
      Eigen::Index largest = 0;
      shares.row(i).maxCoeff(&largest);
      kinds.push_back(static_cast<Kind>(largest));
    }
  }

  /// The frequencies of one kind, ascending.
  std::vector<double> of(Kind kind) const {
    std::vector<double> some;
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (kinds[i] == kind) some.push_back(frequencies[static_cast<Eigen::Index>(i)]);
    return some;
  }
};

class Block : public testing::Test {
 protected:
  static void SetUpTestSuite() { solution = std::make_unique<Solution>(); }
  static void TearDownTestSuite() { solution.reset(); }

  static void expect_first(const std::vector<double>& found, const std::vector<double>& expected, double gate) {
    ASSERT_GE(found.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i] / expected[i], 1, gate) << "mode " << i + 1;
  }

  static std::unique_ptr<Solution> solution;
};
std::unique_ptr<Solution> Block::solution;

TEST_F(Block, HasTheFineReferencesFrequencies) {
  const auto& f = solution->frequencies;
  expect_first({f.begin(), f.end()},
               {.307021, .508556, 1.892610, 3.050202, 4.021947, 5.169176, 7.924144, 8.032075, 9.794555, 12.07299},
               .001);
}

TEST_F(Block, BendsAsTimoshenkosBeam) {
  expect_first(solution->of(Kind::along_z), {.305625, 1.883513, 5.140694, 9.730402}, .01);
  expect_first(solution->of(Kind::along_y), {.506816, 3.037522, 7.989147}, .01);
}

TEST_F(Block, StretchesAndTwistsAsABar) {
  expect_first(solution->of(Kind::along_x), {7.905694, 23.717082}, .01);
  expect_first(solution->of(Kind::twist), {3.991126, 11.973378}, .01);
}

// The mass is consistent and the quadrature of K exact: a nested finer mesh can only lower every frequency.
TEST(Refinement, LowersEveryFrequency) {
  for (const char* type : {"tet4", "tet10", "hex8", "hex20", "wedge15"}) {
    const auto f = [&](const std::string& cells) {
      return frequencies(modes(problem(box("box:1,.1,.06/" + cells + "/" + type), {fixed("xmin")}), 10).modes);
    };
    const Eigen::VectorXd coarse = f("4,1,1"), fine = f("8,2,2"), finer = f("16,4,4");
    EXPECT_TRUE((fine.head(10).array() < coarse.head(10).array()).all()) << type;
    EXPECT_TRUE((finer.head(10).array() < fine.head(10).array()).all()) << type;
  }
}

}  // namespace
}  // namespace ritz::test
