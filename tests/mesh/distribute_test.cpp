// A mesh file cut into parts is the mesh that it was, however many ranks share it.
#include "ritz/mesh/part.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/mesh_fixture.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::mesh {
namespace {

using namespace mesh::testing;

void expect_same(const Mesh& mesh, const Mesh& box) {
  EXPECT_EQ(mesh.vertices_total, box.vertices_total);
  EXPECT_EQ(mesh.cells_total, box.cells_total);
  EXPECT_EQ(mesh.checksum, box.checksum);  // of points, cells, regions and all their numbers
  EXPECT_EQ(mesh.pieces, box.pieces);
  EXPECT_EQ(mesh.connected_parts, box.connected_parts);
  EXPECT_EQ(parallel::sum(world, std::ssize(mesh.boundary)), parallel::sum(world, std::ssize(box.boundary)));
  ASSERT_EQ(mesh.sets.size(), box.sets.size());
  for (std::size_t s = 0; s < mesh.sets.size(); ++s) {
    EXPECT_EQ(mesh.sets[s].name, box.sets[s].name);
    EXPECT_EQ(mesh.sets[s].vertices_total, box.sets[s].vertices_total);
    EXPECT_EQ(mesh.sets[s].faces_total, box.sets[s].faces_total) << mesh.sets[s].name;
  }
}

struct Way {
  std::string cells;
  Partitioner partitioner;
};

class FileMeshCutBy : public ::testing::TestWithParam<Way> {};

INSTANTIATE_TEST_SUITE_P(, FileMeshCutBy,
                         ::testing::Values(Way{"tet4", Partitioner::metis}, Way{"tet10", Partitioner::metis},
                                           Way{"hex8", Partitioner::metis}, Way{"tet4", Partitioner::ptscotch},
                                           Way{"hex8", Partitioner::ptscotch}),
                         [](const auto& info) {
                           return info.param.cells +
                                  (info.param.partitioner == Partitioner::metis ? "_metis" : "_ptscotch");
                         });

TEST_P(FileMeshCutBy, EqualsTheBox) {
  const std::string text = "box:4,3,2/4,3,2/" + GetParam().cells;
  const Mesh mesh = distributed(file_of_box(text), GetParam().partitioner);
  expect_sound(mesh);
  expect_same(mesh, box_mesh(text));
}

TEST_P(FileMeshCutBy, GivesEachRankAShare) {
  const Mesh mesh = distributed(file_of_box("box:8,4,4/8,4,4/" + GetParam().cells), GetParam().partitioner);
  const double mean = static_cast<double>(mesh.cells_total) / parallel::size(world);
  EXPECT_LE(mesh.cells.owned, 1.2 * mean);
  EXPECT_GE(mesh.cells.owned, 0.8 * mean);
}

TEST_P(FileMeshCutBy, MayHaveFewerCellsThanRanks) {
  const std::string text = "box:1,1,2/1,1,2/" + GetParam().cells;
  const Mesh mesh = distributed(file_of_box(text), GetParam().partitioner);
  expect_sound(mesh);
  expect_same(mesh, box_mesh(text));
}

/// Two tetrahedra with `shared` common vertices.
FileMesh pair_sharing(int shared) {
  std::vector<std::array<double, 3>> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::array<Index, 4> second[] = {{4, 5, 6, 7}, {0, 4, 5, 6}, {1, 0, 4, 5}, {0, 2, 1, 4}};
  for (int v = shared; v < 4; ++v) points.push_back({-1.0 - v, -1.0 - v * v, -1.0});
  return tetrahedra(points, {{0, 1, 2, 3}, second[shared]});
}

TEST(Pieces, AreJoinedByFacesAndHingedByVertices) {
  struct Expected {
    int pieces, connected_parts;
    std::size_t joints;
  };
  const Expected expected[] = {{2, 2, 0}, {2, 1, 1}, {2, 1, 2}, {1, 1, 0}};
  for (int shared = 0; shared < 4; ++shared) {
    const Mesh mesh = distributed(pair_sharing(shared));
    expect_sound(mesh);
    EXPECT_EQ(mesh.pieces, expected[shared].pieces) << shared;
    EXPECT_EQ(mesh.connected_parts, expected[shared].connected_parts) << shared;
    ASSERT_EQ(mesh.joints.size(), expected[shared].joints) << shared;
    for (const auto& joint : mesh.joints) {
      EXPECT_EQ(joint.pieces, (std::vector{0, 1}));
      EXPECT_EQ(joint.point[2], 0);
    }
  }
}

TEST(Pieces, OfVerticesAreKnownOnAllRanks) {
  const Mesh mesh = distributed(pair_sharing(0));
  for (int v = 0; v < mesh.local_vertices(); ++v)
    EXPECT_EQ(mesh.vertex_pieces[static_cast<std::size_t>(v)],
              mesh.file_positions[static_cast<std::size_t>(v)] < 4 ? 0 : 1);
}

TEST(FileMesh, CarriesMaterialsSupportsAndSets) {
  FileMesh file = file_of_box("box:2,1,1/2,1,1/hex8");
  file.regions = {{"soft", {1e6, .3, 1000}},
                  {"bare", {.density = 500, .unread_law = "deck.inp:3: law", .unread_density = "deck.inp:5: rho"}}};
  file.cell_regions = {0, 1};
  file.notes = {"deck.inp:9: a note"};
  file.supports = {{{0, 3, 6, 9}, {true, false, true}}};
  file.sets = {{"edge", {2, 5}, {}}, {"nothing", {}, {}}};
  const Mesh mesh = distributed(file);
  ASSERT_EQ(mesh.regions.size(), 2u);
  EXPECT_EQ(mesh.regions[0].name, "soft");
  EXPECT_EQ(mesh.regions[0].material.density, 1000);
  EXPECT_FALSE(mesh.regions[1].material.young);
  EXPECT_EQ(mesh.regions[1].material.density, 500);
  EXPECT_EQ(mesh.regions[1].material.unread_law, "deck.inp:3: law");
  EXPECT_EQ(mesh.regions[1].material.unread_density, "deck.inp:5: rho");
  EXPECT_EQ(mesh.notes, std::vector<std::string>{"deck.inp:9: a note"});
  for (int c = 0; c < mesh.cells.count(); ++c)
    EXPECT_EQ(mesh.cells.regions[static_cast<std::size_t>(c)], mesh.cells.numbers[static_cast<std::size_t>(c)]);
  ASSERT_EQ(mesh.supports.size(), 1u);
  EXPECT_EQ(mesh.supports[0].held, (std::array{true, false, true}));
  for (const int v : mesh.supports[0].vertices) EXPECT_EQ(mesh.points(0, v), 0);
  EXPECT_EQ(mesh.find("edge")->vertices_total, 2);
  EXPECT_EQ(mesh.find("nothing")->vertices_total, 0);
}

TEST(FileMesh, GivesSetsWithoutListedFacesTheirSurface) {
  FileMesh file = file_of_box("box:2,1,1/2,1,1/hex8");
  for (auto& set : file.sets) set.faces.clear();
  const Mesh mesh = distributed(file);
  EXPECT_EQ(mesh.find("xmin")->faces_total, 1);
  EXPECT_EQ(mesh.find("ymax")->faces_total, 2);
  EXPECT_EQ(mesh.find("body")->faces_total, 10);
}

TEST(FileMesh, LosesVerticesThatNoCellUses) {
  FileMesh mesh = tetrahedra({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}, {0, 0, 1}}, {{1, 2, 4, 5}});
  mesh.sets = {{"some", {0, 1, 3, 5}, {{fem::FaceType::tri3, {1, 4, 2}}}}};
  mesh.supports = {{{3, 4}, {true, true, true}}};
  EXPECT_EQ(drop_unused_vertices(mesh), 2);
  EXPECT_EQ(mesh.vertex_ids, (std::vector<Index>{2, 3, 5, 6}));
  EXPECT_EQ(mesh.cell_vertices, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(mesh.points[2], (std::array{0.0, 1.0, 0.0}));
  EXPECT_EQ(mesh.sets[0].vertices, (std::vector<Index>{0, 3}));
  EXPECT_EQ(mesh.sets[0].faces[0].vertices[1], 2);
  EXPECT_EQ(mesh.supports[0].vertices, (std::vector<Index>{2}));
  EXPECT_EQ(drop_unused_vertices(mesh), 0);
}

}  // namespace
}  // namespace ritz::mesh
