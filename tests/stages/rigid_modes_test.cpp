// How many ways a body can move rigidly: counted from connectivity and supports, and again by the inertia of K - σM.
#include <gtest/gtest.h>

#include "support/lattice_mesh.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

using Corners = std::vector<Hexahedron>;
constexpr std::array<bool, 3> only_yz = {false, true, true};

int rigid_modes(const Corners& hexahedra, fem::CellType type, const std::vector<mesh::Fixed>& supports = {}) {
  const auto mesh = lattice_mesh(hexahedra, type, stretched({1, 1, 1}, {.2, .3, .25}));
  const auto result = modes(problem(distributed(mesh), supports), 4);
  return rigid_count(result.modes);
}

class RigidModes : public testing::TestWithParam<fem::CellType> {};

TEST_P(RigidModes, OfFreePieces) {
  EXPECT_EQ(rigid_modes({{0, 0, 0}}, GetParam()), 6);
  EXPECT_EQ(rigid_modes({{0, 0, 0}, {1, 0, 0}}, GetParam()), 6);
  EXPECT_EQ(rigid_modes({{0, 0, 0}, {2, 0, 0}}, GetParam()), 12);
  EXPECT_EQ(rigid_modes({{0, 0, 0}, {1, 1, 1}}, GetParam()), 9);
  EXPECT_EQ(rigid_modes({{0, 0, 0}, {1, 1, 0}}, GetParam()), 7);
}

TEST_P(RigidModes, OfChainsOfPieces) {
  // Three in a row, each sharing a vertex with the next: 6 + 3 + 3; a hinged pair beside a free one: 7 + 6.
  EXPECT_EQ(rigid_modes({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, GetParam()), 12);
  EXPECT_EQ(rigid_modes({{0, 0, 0}, {1, 1, 0}, {5, 0, 0}}, GetParam()), 13);
}

TEST_P(RigidModes, OfSupportedBodies) {
  const Corners beam = grid(3, 1, 1);
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero(), e = Eigen::Vector3d::Constant(1e-9);
  const auto line = fixed_between(-e, Eigen::Vector3d(0, .3, 0) + e);
  EXPECT_EQ(rigid_modes(beam, GetParam(), {fixed_between(origin - e, origin + e)}), 3);
  EXPECT_EQ(rigid_modes(beam, GetParam(), {line}), 1);
  EXPECT_EQ(rigid_modes(beam, GetParam(), {fixed_between({-e.x(), -1, -1}, {e.x(), 1, 1})}), 0);
}

TEST_P(RigidModes, OfSliders) {
  const Corners beam = grid(3, 1, 1);
  const auto left = fixed_between({-1e-9, -1, -1}, {1e-9, 1, 1}, only_yz);
  const auto right = fixed_between({.6 - 1e-9, -1, -1}, {.6 + 1e-9, 1, 1}, only_yz);
  // A plane end held in its plane still lets the body slide and nod about the two axes of the plane.
  EXPECT_EQ(rigid_modes(beam, GetParam(), {left}), 3);
  EXPECT_EQ(rigid_modes(beam, GetParam(), {left, right}), 1);
}

TEST_P(RigidModes, OfPartlySupportedMechanisms) {
  // The first of two cubes hinged along an edge is clamped: the other one swings.
  const auto clamp = fixed_between({-1e-9, -1, -1}, {1e-9, 1, 1});
  EXPECT_EQ(rigid_modes({{0, 0, 0}, {1, 1, 0}}, GetParam(), {clamp}), 1);
  EXPECT_EQ(rigid_modes({{0, 0, 0}, {1, 1, 1}}, GetParam(), {clamp}), 3);
}

INSTANTIATE_TEST_SUITE_P(, RigidModes, testing::ValuesIn(fem::cell_types),
                         [](const auto& info) { return std::string(fem::shape(info.param).name); });

}  // namespace
}  // namespace ritz::test
