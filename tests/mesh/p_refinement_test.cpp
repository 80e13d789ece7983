// Quadratic cells on a mesh of linear ones, against the boxes of quadratic cells that the generator makes.
#include "ritz/mesh/p_refinement.hpp"

#include <gtest/gtest.h>

#include "mesh/mesh_fixture.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::mesh {
namespace {

using namespace mesh::testing;
using Supports = std::vector<Fixed>;

Fixed on(const std::string& set, std::array<bool, 3> which = {true, true, true}) { return {set, which, set}; }
Fixed within(const Region3& box) { return {box, {true, true, true}, "box"}; }

class PRefined : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(PRefined, HasTheVerticesAndSupportsOfQuadraticCells) {
  const std::string box = "box:1,.8,.6/3,3,2/";
  const auto [linear_type, quadratic_type] = GetParam();
  const Mesh linear = box_mesh(box + linear_type), quadratic = box_mesh(box + quadratic_type);
  for (const Supports& supports : {Supports{}, Supports{on("xmin")}, Supports{on("ymin", {false, true, false})},
                                   Supports{on("xmin", {true, false, false}), on("zmax", {false, false, true})},
                                   Supports{within({{-1, -1e-9, -1e-9}, {2, 1e-9, 1e-9}})}}) {
    const auto refined = p_refine(linear, number(linear, supports, FileSupports::used));
    EXPECT_EQ(refined.mesh.vertices_total, quadratic.vertices_total);
    EXPECT_EQ(refined.mesh.cells_total, quadratic.cells_total);
    EXPECT_EQ(refined.dofs.total, number(quadratic, supports, FileSupports::used).total);
  }
}

TEST_P(PRefined, TakesOverWhatIsLinear) {
  const Mesh linear = box_mesh(std::string("box:1,.8,.6/3,3,2/") + GetParam().first);
  const auto refined = p_refine(linear, number(linear, {}, FileSupports::used));
  const Eigen::Matrix3d G{{1, 2, -1}, {0, 3, 1}, {-2, 1, 2}};
  const auto field = [&](const Mesh& mesh) {
    VertexRows u(3 * mesh.owned, 1);
    for (int v = 0; v < mesh.owned; ++v) at_vertex(u, v) = G * mesh.points.col(v) + Eigen::Vector3d(1, 2, 3);
    return u;
  };
  const VertexRows fine = interpolate(linear, refined.ends, field(linear)), expected = field(refined.mesh);
  EXPECT_LT(parallel::max(world, (fine - expected).cwiseAbs().sum()), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(, PRefined,
                         ::testing::Values(std::pair{"tet4", "tet10"}, std::pair{"hex8", "hex20"},
                                           std::pair{"wedge6", "wedge15"}),
                         [](const auto& info) { return std::string(info.param.first); });

TEST(PRefinement, LeavesAnEdgeBetweenTwoSupportsFree) {
  const Eigen::Vector3d near_xmin(1. / 3, .8 / 3, .3), little = Eigen::Vector3d::Constant(1e-9);
  const Supports supports = {on("xmin"), within({near_xmin - little, near_xmin + little})};
  const Mesh linear = box_mesh("box:1,.8,.6/3,3,2/hex8"), quadratic = box_mesh("box:1,.8,.6/3,3,2/hex20");
  const auto refined = p_refine(linear, number(linear, supports, FileSupports::used));
  EXPECT_EQ(refined.dofs.total, number(quadratic, supports, FileSupports::used).total);
}

TEST(PRefinement, IsForCellsWithAQuadraticType) {
  EXPECT_TRUE(can_be_p_refined(fem::CellType::wedge6));
  EXPECT_FALSE(can_be_p_refined(fem::CellType::tet10));
  EXPECT_FALSE(can_be_p_refined(fem::CellType::pyramid5));
}

}  // namespace
}  // namespace ritz::mesh
