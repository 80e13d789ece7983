// Generated boxes: numbers, shapes and face sets against closed forms, the distribution against its definition.
#include "ritz/mesh/box.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "mesh/mesh_fixture.hpp"
#include "ritz/base/error.hpp"
#include "ritz/fem/face.hpp"
#include "ritz/fem/geometry.hpp"
#include "ritz/mesh/quality.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::mesh {
namespace {

using namespace mesh::testing;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const Eigen::Vector3d lengths(5, 1.5, 2);
const std::array<Index, 3> counts = {5, 3, 2};
constexpr Index hexahedra = 5 * 3 * 2;

struct Kind {
  std::string name;
  Index step, cells, faces;  ///< grid steps and cells a hexahedron, triangles or quadrilaterals a side of it
};

class BoxOf : public ::testing::TestWithParam<Kind> {
 protected:
  Mesh mesh = box_mesh("box:5,1.5,2/5,3,2/" + GetParam().name);
  Index step = GetParam().step;
  Index points(std::size_t d) const { return step * counts[d] + 1; }
};

INSTANTIATE_TEST_SUITE_P(, BoxOf,
                         ::testing::Values(Kind{"tet4", 1, 6, 2}, Kind{"tet10", 2, 6, 2}, Kind{"hex8", 1, 1, 1}),
                         [](const auto& info) { return info.param.name; });

TEST_P(BoxOf, IsDistributedSoundly) { expect_sound(mesh); }

TEST_P(BoxOf, HasTheCountsOfItsGrid) {
  EXPECT_EQ(mesh.vertices_total, points(0) * points(1) * points(2));
  EXPECT_EQ(mesh.cells_total, GetParam().cells * hexahedra);
  EXPECT_EQ(mesh.pieces, 1);
  EXPECT_EQ(mesh.connected_parts, 1);
  ASSERT_EQ(mesh.regions.size(), 1u);
  EXPECT_EQ(mesh.regions[0].name, "body");
}

TEST_P(BoxOf, NumbersVerticesXFastest) {
  for (int v = 0; v < mesh.local_vertices(); ++v) {
    const Index n = mesh.file_positions[static_cast<std::size_t>(v)];
    EXPECT_EQ(mesh.ids[static_cast<std::size_t>(v)], n + 1);
    const Index i = n % points(0), j = n / points(0) % points(1), k = n / points(0) / points(1);
    const Eigen::Vector3d x(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
    const Eigen::Vector3d grid(static_cast<double>(points(0) - 1), static_cast<double>(points(1) - 1),
                               static_cast<double>(points(2) - 1));
    EXPECT_LE((mesh.points.col(v) - x.cwiseProduct(lengths).cwiseQuotient(grid)).norm(), 1e-15);
  }
}

TEST_P(BoxOf, FillsItsVolumeWithRightHandedCells) {
  EXPECT_NO_THROW(refuse_inverted_cells(mesh));
  double volume = 0;
  for (int c = 0; c < mesh.cells.owned; ++c) {
    const auto x = mesh.corners(c);
    const auto edge = [&](int v) { return Eigen::Vector3d(x.col(v) - x.col(0)); };
    const bool hex = GetParam().name == "hex8";
    volume += hex ? edge(1).cross(edge(3)).dot(edge(4)) : edge(1).cross(edge(2)).dot(edge(3)) / 6;
  }
  EXPECT_NEAR(parallel::sum(world, volume), lengths.prod(), 1e-13);
}

TEST_P(BoxOf, CutsHexahedraAsKuhnDid) {
  if (GetParam().name == "hex8") return;
  const Eigen::Vector3d h = lengths.cwiseQuotient(Eigen::Vector3d(5, 3, 2));
  for (int c = 0; c < mesh.cells.owned; ++c) {
    const auto x = mesh.corners(c);
    int diagonals = 0;  // from the lowest corner of the hexahedron to its highest
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) diagonals += (x.col(a) - x.col(b) - h).norm() < 1e-14;
    EXPECT_EQ(diagonals, 1);
  }
}

TEST_P(BoxOf, PutsMidEdgeVerticesInTheMiddle) {
  if (GetParam().name != "tet10") return;
  const std::array<std::pair<int, int>, 6> edges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  for (int c = 0; c < mesh.cells.count(); ++c) {
    const auto x = mesh.corners(c);
    for (int e = 0; e < 6; ++e) {
      const auto& [a, b] = edges[static_cast<std::size_t>(e)];
      EXPECT_LE((x.col(4 + e) - (x.col(a) + x.col(b)) / 2).norm(), 1e-15);
    }
  }
}

TEST_P(BoxOf, NamesItsSides) {
  const std::array<const char*, 6> names = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};
  for (std::size_t side = 0; side < 6; ++side) {
    const auto d = side / 2, e = (d + 1) % 3, f = (d + 2) % 3;
    const double plane = side % 2 ? lengths[static_cast<Eigen::Index>(d)] : 0;
    const Set* set = mesh.find(names[side]);
    ASSERT_NE(set, nullptr);
    std::vector<int> expected;
    for (int v = 0; v < mesh.local_vertices(); ++v)
      if (mesh.points(static_cast<Eigen::Index>(d), v) == plane) expected.push_back(v);
    EXPECT_EQ(set->vertices, expected) << names[side];
    EXPECT_EQ(set->vertices_total, points(e) * points(f));
    EXPECT_EQ(set->faces_total, GetParam().faces * counts[e] * counts[f]);
    EXPECT_EQ(parallel::sum(world, std::ssize(set->faces)), set->faces_total);
    for (const auto face : set->faces)
      for (const int v : face_vertices(mesh, face)) EXPECT_EQ(mesh.points(static_cast<Eigen::Index>(d), v), plane);
  }
  EXPECT_EQ(mesh.find("body")->vertices_total, mesh.vertices_total);
  EXPECT_EQ(mesh.find("xmid"), nullptr);
}

TEST_P(BoxOf, HasAClosedSurface) {
  const Index sides = 2 * (counts[0] * counts[1] + counts[1] * counts[2] + counts[2] * counts[0]);
  EXPECT_EQ(parallel::sum(world, std::ssize(mesh.boundary)), GetParam().faces * sides);
  for (const auto face : mesh.boundary) EXPECT_LT(face.cell, mesh.cells.owned);
  EXPECT_EQ(std::set<CellFace>(mesh.boundary.begin(), mesh.boundary.end()).size(), mesh.boundary.size());
}

class EveryBox : public ::testing::TestWithParam<fem::CellType> {
 protected:
  fem::CellType type = GetParam();
  Mesh mesh = box_mesh("box:5,1.5,2/5,3,2/" + std::string(fem::shape(type).name));
};

INSTANTIATE_TEST_SUITE_P(, EveryBox,
                         ::testing::Values(fem::CellType::tet4, fem::CellType::tet10, fem::CellType::hex8,
                                           fem::CellType::hex20, fem::CellType::wedge6, fem::CellType::wedge15),
                         [](const auto& info) { return std::string(fem::shape(info.param).name); });

TEST_P(EveryBox, IsDistributedSoundly) { expect_sound(mesh); }

TEST_P(EveryBox, NumbersVerticesXFastestWithoutGaps) {
  const Mesh whole = box_mesh("box:5,1.5,2/5,3,2/" + std::string(fem::shape(type).name), MPI_COMM_SELF);
  EXPECT_EQ(whole.owned, whole.vertices_total);
  EXPECT_EQ(whole.vertices_total, mesh.vertices_total);
  for (int v = 0; v < whole.owned; ++v) {
    EXPECT_EQ(whole.file_positions[static_cast<std::size_t>(v)], v);
    if (v == 0) continue;
    const Eigen::Vector3d a = whole.points.col(v - 1).reverse(), b = whole.points.col(v).reverse();
    EXPECT_TRUE(std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end())) << v;
  }
  EXPECT_EQ(mesh.checksum, whole.checksum);
}

TEST_P(EveryBox, IsFilledByStraightRightHandedCells) {
  EXPECT_NO_THROW(refuse_inverted_cells(mesh));
  double volume = 0;
  for (int c = 0; c < mesh.cells.owned; ++c) {
    EXPECT_TRUE(fem::straight(type, mesh.corners(c)));
    volume += fem::volume(type, mesh.corners(c));
  }
  EXPECT_NEAR(parallel::sum(world, volume), lengths.prod(), 1e-13);
}

TEST_P(EveryBox, HasSidesOfTheirAreas) {
  const std::array<const char*, 6> names = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};
  for (std::size_t side = 0; side < 6; ++side) {
    double area = 0;
    for (const auto face : mesh.find(names[side])->faces)
      area += fem::area(fem::side(type, face.face).type, mesh.points(Eigen::all, face_vertices(mesh, face)));
    const auto across = static_cast<Eigen::Index>(side / 2);
    EXPECT_NEAR(parallel::sum(world, area), lengths.prod() / lengths[across], 1e-13) << names[side];
  }
}

TEST_P(BoxOf, HasTheSameChecksumOnAnyNumberOfRanks) {
  const std::string text = "box:5,1.5,2/5,3,2/" + GetParam().name;
  EXPECT_EQ(mesh.checksum, box_mesh(text, MPI_COMM_SELF).checksum);
  EXPECT_NE(mesh.checksum, box_mesh("box:5,1.5,2.0000000001/5,3,2/" + GetParam().name).checksum);
}

TEST(Box, MayHaveFewerCellsThanRanks) {
  for (const char* text : {"box:1,1,1/1,1,1/hex8", "box:1,1,1/1,1,1/tet10", "box:1,2,1/1,2,1/hex8"}) {
    const Mesh mesh = box_mesh(text);
    expect_sound(mesh);
    EXPECT_EQ(mesh.find("zmax")->faces_total, mesh.find("zmin")->faces_total);
  }
}

TEST(Box, IsReadFromItsOption) {
  EXPECT_TRUE(names_box("box:"));
  EXPECT_FALSE(names_box("boxes.msh"));
  const Box box = parse_box("box:1e-3,2.5,30/4,50,6/tet10");
  EXPECT_EQ(box.lengths, (std::array{1e-3, 2.5, 30.0}));
  EXPECT_EQ(box.cells, (std::array<Index, 3>{4, 50, 6}));
  EXPECT_EQ(box.type, fem::CellType::tet10);
}

TEST(Box, SaysWhatIsWrongWithItsOption) {
  for (const char* text :
       {"box:1,1/1,1,1/tet4", "box:1,1,1/1,1/tet4", "box:1,1,1/1,1,1", "box:1,1,1/1,1,1/tet5", "box:1,1,x/1,1,1/tet4",
        "box:1,1,1/1,1.5,1/tet4", "box:0,1,1/1,1,1/tet4", "box:1,1,inf/1,1,1/tet4", "box:1,1,1/1,-1,1/tet4",
        "box:1,1,1/9999,9999,9999/hex8", "box:1,1,1/1,1,1/tet4/tet4", "box:1,1,1,1/1,1,1/tet4", "box:"})
    EXPECT_THAT([&] { parse_box(text); }, ThrowsMessage<InputError>(HasSubstr(text))) << text;
}

}  // namespace
}  // namespace ritz::mesh
