// Cells that mid-edge vertices bend or fold, on any number of ranks.
#include "ritz/mesh/quality.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/mesh_fixture.hpp"
#include "ritz/base/error.hpp"
#include "support/listed_mesh.hpp"

namespace ritz::mesh {
namespace {

using namespace mesh::testing;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::ThrowsMessage;

/// `count` quadratic tetrahedra far apart, numbered from 1; in those of `bent`, the vertex on the edge from corner 0 to
/// corner 1 stands at the fraction `at` of it.
Mesh tetrahedra(int count, const std::vector<int>& bent, double at) {
  test::Points points;
  std::vector<test::ListedCell> cells;
  for (int c = 0; c < count; ++c) {
    const double x = 3. * c;
    const bool moved = std::find(bent.begin(), bent.end(), c + 1) != bent.end();
    const auto first = static_cast<Index>(points.size());
    for (const auto& p : test::Points{{0, 0, 0},
                                      {1, 0, 0},
                                      {0, 1, 0},
                                      {0, 0, 1},
                                      {moved ? at : .5, 0, 0},
                                      {.5, .5, 0},
                                      {0, .5, 0},
                                      {0, 0, .5},
                                      {.5, 0, .5},
                                      {0, .5, .5}})
      points.push_back({x + p[0], p[1], p[2]});
    cells.push_back({fem::CellType::tet10, {}});
    for (Index v = 0; v < 10; ++v) cells.back().vertices.push_back(first + v);
  }
  return distributed(test::listed_mesh(points, cells));
}

std::vector<std::string> bent_warnings(const Mesh& mesh) {
  auto all = warnings(mesh);
  std::erase_if(all, [](const std::string& text) { return text.find("mid-edge") == text.npos; });
  return all;
}

TEST(BentCells, AreSolvedWithAWarningThatNamesThem) {
  for (const double at : {.25, .24}) {  // at the quarter point, and a little short of it
    const auto mesh = tetrahedra(7, {3, 6}, at);
    EXPECT_NO_THROW(refuse_inverted_cells(mesh));
    EXPECT_THAT(bent_warnings(mesh), ElementsAre(AllOf(HasSubstr("2 cells (3, 6)"), HasSubstr("at a corner"))));
  }
}

TEST(BentCells, AreNamedUpToFive) {
  const auto mesh = tetrahedra(8, {1, 2, 3, 5, 6, 8}, .25);
  EXPECT_THAT(bent_warnings(mesh), ElementsAre(HasSubstr("6 cells (1, 2, 3, 5, 6, ...)")));
}

TEST(BentCells, ThatArePositiveAtTheirCornersAreNotSpokenOf) {
  EXPECT_THAT(bent_warnings(tetrahedra(3, {2}, .3)), IsEmpty());
  EXPECT_THAT(bent_warnings(tetrahedra(3, {}, .5)), IsEmpty());
}

TEST(FoldedCells, AreRefusedForTheirMidEdgeVertices) {
  for (const double at : {.1, .95}) {
    const auto mesh = tetrahedra(5, {2, 4}, at);
    EXPECT_THAT([&] { refuse_inverted_cells(mesh); },
                ThrowsMessage<InputError>(AllOf(HasSubstr("cell 2 of the mesh"), HasSubstr("(2 such in all)"),
                                                HasSubstr("mid-edge"), Not(HasSubstr("reverse")))));
  }
}

TEST(InvertedCells, AreRefusedForTheirOrder) {
  test::Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 0}};
  const auto mesh = distributed(
      test::listed_mesh(points, {{fem::CellType::tet4, {0, 1, 2, 3}}, {fem::CellType::tet4, {0, 1, 2, 4}}}));
  EXPECT_THAT([&] { refuse_inverted_cells(mesh); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("cell 2 of the mesh"), HasSubstr("reverse the order"))));
}

}  // namespace
}  // namespace ritz::mesh
