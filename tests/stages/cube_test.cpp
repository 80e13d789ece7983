// The free cube with ν = .3: dimensionless frequencies ωL/c_s and their multiplicities.
#include <gtest/gtest.h>

#include "support/lattice_mesh.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

constexpr double half = .25;  // m, half an edge
const double scale = 2 * half / std::sqrt(soft.at_rest().mu / soft.density);

constexpr std::array<std::pair<double, int>, 6> expected = {
    {{2.85608, 2}, {3.84599, 3}, {3.91125, 3}, {4.442883, 3}, {4.57281, 3}, {4.79258, 3}}};

/// The eighth [0, half]³ of the cube, of quadratic tetrahedra, 4 cubes of them along an edge. On each middle plane the
/// motion is its own mirror image (the normal component is zero), or against it (the tangential ones are).
Problem eighth(const std::array<bool, 3>& mirrored) {
  constexpr int n = 4;
  std::vector<mesh::Fixed> supports;
  for (int d = 0; d < 3; ++d) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(-1), high = Eigen::Vector3d::Constant(1);
    low[d] = -1e-9;
    high[d] = 1e-9;
    const bool mirror = mirrored[static_cast<std::size_t>(d)];
    supports.push_back(fixed_between(low, high, {mirror == (d == 0), mirror == (d == 1), mirror == (d == 2)}));
  }
  const auto mesh =
      lattice_mesh(grid(n, n, n), fem::CellType::tet10, stretched({n, n, n}, Eigen::Vector3d::Constant(half)));
  return problem(distributed(mesh), supports);
}

TEST(Cube, HasItsFrequencies) {
  std::vector<double> omega;
  int rigid = 0;
  // Every class of symmetry, and how often it occurs when the axes change places.
  for (const auto& [mirrored, times] : {std::pair{std::array{true, true, true}, 1},
                                        {{true, true, false}, 3},
                                        {{true, false, false}, 3},
                                        {{false, false, false}, 1}}) {
    const auto result = modes(eighth(mirrored), 5);
    rigid += times * rigid_count(result.modes);
    for (const double lambda : flexible(result.modes))
      omega.insert(omega.end(), static_cast<std::size_t>(times), std::sqrt(lambda) * scale);
  }
  EXPECT_EQ(rigid, 6);
  std::sort(omega.begin(), omega.end());
  auto next = omega.begin();
  for (const auto& [value, times] : expected)
    for (int i = 0; i < times; ++i) EXPECT_NEAR(*next++ / value, 1, 1e-4);
}

// A mesh with all symmetries of the cube has its multiplicities exactly. (Those at √2 π, pure shear in one of three
// planes, agree by accident, not by symmetry: the mesh splits them into two and one.)
TEST(Cube, HasItsMultiplicities) {
  constexpr int n = 3;
  const auto mesh =
      lattice_mesh(grid(n, n, n), fem::CellType::tet10, stretched({n, n, n}, Eigen::Vector3d::Constant(2 * half)));
  const auto result = modes(problem(distributed(mesh), {}), 18);
  EXPECT_EQ(rigid_count(result.modes), 6);
  const Eigen::VectorXd omega = flexible(result.modes).cwiseSqrt() * scale;
  for (Eigen::Index i = 0; const int times : {2, 3, 3, 2, 1, 3, 3}) {
    EXPECT_LE(omega[i + times - 1] / omega[i] - 1, 1e-9) << "of a multiple eigenvalue";
    EXPECT_GT(omega[i + times] / omega[i + times - 1] - 1, 1e-4);
    i += times;
  }
}

}  // namespace
}  // namespace ritz::test
