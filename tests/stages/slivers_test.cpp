// A flat tetrahedron inside a beam: however flat, the low modes stay, and a warning tells of it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "ritz/base/error.hpp"
#include "ritz/mesh/quality.hpp"
#include "support/lattice_mesh.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

mesh::FileMesh beam() { return lattice_mesh(grid(10, 2, 1), fem::CellType::tet4, stretched({10, 2, 1}, {1, .2, .1})); }

/// Cell `cell` cut into four by a vertex so near to the middle of its first face that the tetrahedron between them has
/// a smallest dihedral angle of `degrees`.
mesh::FileMesh with_sliver(double degrees) {
  auto mesh = beam();
  const std::size_t cell = mesh.cell_types.size() / 2;
  const std::array<mesh::Index, 4> v = {mesh.cell_vertices[4 * cell], mesh.cell_vertices[4 * cell + 1],
                                        mesh.cell_vertices[4 * cell + 2], mesh.cell_vertices[4 * cell + 3]};
  const auto point = [&](std::size_t i) { return Eigen::Vector3d(mesh.points[static_cast<std::size_t>(v[i])].data()); };
  const Eigen::Vector3d centre = (point(0) + point(1) + point(2)) / 3;
  const Eigen::Vector3d normal = (point(1) - point(0)).cross(point(2) - point(0)).normalized();
  double farthest = 0;  // of the face's edges from its centre
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d along = (point((i + 1) % 3) - point(i)).normalized();
    farthest = std::max(farthest, along.cross(centre - point(i)).norm());
  }
  const Eigen::Vector3d x = centre + std::tan(degrees * std::numbers::pi / 180) * farthest * normal;
  const auto added = static_cast<mesh::Index>(mesh.points.size());
  mesh.points.push_back({x.x(), x.y(), x.z()});
  mesh.vertex_ids.push_back(added + 1);
  for (std::size_t i = 0; i < 4; ++i) {
    auto part = v;
    part[i] = added;
    if (i == 3) std::copy(part.begin(), part.end(), mesh.cell_vertices.begin() + static_cast<std::ptrdiff_t>(4 * cell));
    else {
      mesh.cell_vertices.insert(mesh.cell_vertices.end(), part.begin(), part.end());
      mesh.cell_offsets.push_back(static_cast<mesh::Index>(mesh.cell_vertices.size()));
      mesh.cell_types.push_back(fem::CellType::tet4);
      mesh.cell_ids.push_back(static_cast<mesh::Index>(mesh.cell_types.size()));
      mesh.cell_regions.push_back(0);
    }
  }
  return mesh;
}

Eigen::VectorXd low_modes(const mesh::FileMesh& mesh) {
  const Problem p = problem(distributed(mesh), {fixed_between({-1e-9, -1, -1}, {1e-9, 1, 1})});
  return frequencies(modes(p, 6).modes).head(6);
}

bool warns_of_angles(double degrees) {
  for (const auto& text : mesh::warnings(distributed(with_sliver(degrees))))
    if (text.find("1 degree") != text.npos) return true;
  return false;
}

TEST(Slivers, LeaveTheLowModesAlone) {
  const Eigen::VectorXd without = low_modes(beam());
  for (const double degrees : {.1, .01, .001, 1e-4}) {
    const Eigen::VectorXd f = low_modes(with_sliver(degrees));
    EXPECT_LE((f - without).cwiseQuotient(without).cwiseAbs().maxCoeff(), 1e-6) << degrees << " degrees";
  }
}

TEST(Slivers, OfAMillionthOfADegreeAreSolvedOrRefused) {
  try {
    low_modes(with_sliver(1e-6));
  } catch (const NumericalError&) {
    SUCCEED();
  }
}

TEST(Slivers, AreNamed) {
  for (const double degrees : {.999, .1, 1e-4, 1e-6}) EXPECT_TRUE(warns_of_angles(degrees)) << degrees;
  EXPECT_FALSE(warns_of_angles(1.001));
}

}  // namespace
}  // namespace ritz::test
