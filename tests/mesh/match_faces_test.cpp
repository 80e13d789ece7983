// Which cells share a face: also across types of cells; and which cannot be.
#include "ritz/mesh/topology.hpp"

#include <gmock/gmock.h>

#include "mesh/mesh_fixture.hpp"
#include "ritz/base/error.hpp"
#include "ritz/mesh/quality.hpp"
#include "support/listed_mesh.hpp"

namespace ritz::mesh {
namespace {

using mesh::testing::distributed;
using mesh::testing::tetrahedra;
using test::Diagonal;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;
using ::testing::UnorderedElementsAre;

const test::Points corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {.9, .9, .9}};

TEST(Faces, OfAHexahedronMatchTwoTriangles) {
  for (const auto diagonal : {Diagonal::from_4_to_6, Diagonal::from_5_to_7}) {
    const auto file = test::cube_with_cap(diagonal);
    const auto matched = match_faces(file);
    using Pair = std::array<Index, 2>;
    EXPECT_THAT(matched.neighbours, UnorderedElementsAre(Pair{1, 2}, Pair{0, 1}, Pair{0, 2}));
    EXPECT_EQ(matched.boundary.size(), 5u + 4u);
    EXPECT_EQ(matched.hanging, 0);
    const Mesh mesh = distributed(file);
    EXPECT_EQ(mesh.pieces, 1);
    EXPECT_THAT(mesh.joints, IsEmpty());
    EXPECT_THAT(warnings(mesh), IsEmpty());
  }
}

TEST(Faces, OfAHexahedronBesideOneTriangleStayOpen) {
  auto file = test::cube_with_cap(Diagonal::from_4_to_6);
  file.cell_types.pop_back();
  file.cell_offsets.pop_back();
  file.cell_vertices.resize(12);
  const auto matched = match_faces(file);
  EXPECT_THAT(matched.neighbours, IsEmpty());
  EXPECT_EQ(matched.boundary.size(), 6u + 4u);
}

TEST(Faces, ThatDoNotConformAreWarnedOf) {
  auto points = corners;
  points.resize(5);
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}) {
    const auto &x = points[static_cast<std::size_t>(a)], &y = points[static_cast<std::size_t>(b)];
    points.push_back({(x[0] + y[0]) / 2, (x[1] + y[1]) / 2, (x[2] + y[2]) / 2});
  }
  const Mesh mesh = distributed(test::listed_mesh(
      points, {{fem::CellType::tet10, {0, 1, 2, 3, 5, 6, 7, 8, 9, 10}}, {fem::CellType::tet4, {1, 2, 3, 4}}}));
  EXPECT_EQ(mesh.hanging_faces, 1);
  EXPECT_EQ(mesh.pieces, 1);
  EXPECT_THAT(warnings(mesh),
              ElementsAre(HasSubstr("1 face joins a quadratic cell to one without its mid-edge vertices")));
}

TEST(Faces, OfTheSameCellTwiceAreRefused) {
  const auto twice = tetrahedra(corners, {{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 0, 3}});
  EXPECT_THAT([&] { match_faces(twice); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("cells 1 and 3"), HasSubstr("same corners"))));
  EXPECT_THROW(distributed(twice), InputError);
}

TEST(Faces, OfThreeCellsAreRefused) {
  EXPECT_THAT(
      [&] {
        match_faces(tetrahedra(corners, {{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 5}}));
      },
      ThrowsMessage<InputError>(HasSubstr("cells 1, 2 and 3")));
}

}  // namespace
}  // namespace ritz::mesh
