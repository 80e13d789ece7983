// The numbering of free degrees of freedom against counting by hand, on any number of ranks.
#include "ritz/mesh/dofs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "mesh/mesh_fixture.hpp"
#include "ritz/base/error.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::mesh {
namespace {

// Rows of one kind are not taken for another: that does not compile.
template <class U>
concept OverFree = requires(const Mesh& mesh, const Dofs& dofs, const U& u) {
  to_vertices(mesh, dofs, u);
};
template <class U>
concept OverVertices = requires(const Mesh& mesh, const Dofs& dofs, const U& u) {
  from_vertices(mesh, dofs, u);
  with_ghosts(mesh, u, components);
};
template <class U>
concept OverLocals = requires(const Mesh& mesh, U& u) {
  mesh.halo.fill_ghosts(mesh.comm, u, components);
};
static_assert(OverFree<FreeRows> && !OverFree<VertexRows> && !OverFree<LocalRows>);
static_assert(!OverVertices<FreeRows> && OverVertices<VertexRows> && !OverVertices<LocalRows>);
static_assert(!OverLocals<FreeRows> && !OverLocals<VertexRows> && OverLocals<LocalRows>);
static_assert(!std::is_assignable_v<FreeRows&, const VertexRows&>);
static_assert(OverFree<algebra::Tall>, "what has no kind may become any");

using namespace mesh::testing;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr const char* text = "box:3,2,1/3,2,1/hex8";  // 4 x 3 x 2 vertices
constexpr Index all = 3 * 24;
constexpr double infinite = std::numeric_limits<double>::infinity();

Fixed set(const std::string& name, std::array<bool, 3> which = {true, true, true}) { return {name, which, name}; }

Dofs number(const Mesh& mesh, const std::vector<Fixed>& supports) { return number(mesh, supports, FileSupports::used); }

/// Free numbers are contiguous by rank and vertex, ghosts have their owners', fixed ones are -1.
void expect_sound(const Mesh& mesh, const Dofs& dofs) {
  std::vector<Index> positions;
  for (const Index v : mesh.file_positions)
    for (Index c = 0; c < 3; ++c) positions.push_back(3 * v + c);
  expect_agreement(positions, dofs.numbers);
  Index next = dofs.first;
  for (int v = 0; v < mesh.owned; ++v)
    for (int c = 0; c < 3; ++c) EXPECT_EQ(dofs.number(v, c), dofs.fixed(v, c) ? -1 : next++);
  EXPECT_EQ(next, dofs.first + dofs.owned);
  EXPECT_EQ(dofs.first, parallel::sum_before(world, Index{dofs.owned}));
  EXPECT_EQ(parallel::sum(world, Index{dofs.owned}), dofs.total);
}

class DofsOfABox : public ::testing::Test {
 protected:
  Mesh mesh = box_mesh(text);

  std::uint64_t checksum_alone(const std::vector<Fixed>& supports) const {
    return number(box_mesh(text, MPI_COMM_SELF), supports).checksum;
  }
};

TEST_F(DofsOfABox, AreAllFreeWithoutSupports) {
  const Dofs dofs = number(mesh, {});
  expect_sound(mesh, dofs);
  EXPECT_EQ(dofs.total, all);
  EXPECT_EQ(dofs.block, 3);
  EXPECT_EQ(dofs.checksum, 0u);
}

TEST_F(DofsOfABox, LackTheVerticesOfASet) {
  const Dofs dofs = number(mesh, {set("xmin")});
  expect_sound(mesh, dofs);
  EXPECT_EQ(dofs.total, all - 3 * 6);
  EXPECT_EQ(dofs.block, 3);
  for (int v = 0; v < mesh.local_vertices(); ++v) EXPECT_EQ(dofs.fixed(v, 1), mesh.points(0, v) == 0);
  EXPECT_EQ(dofs.checksum, checksum_alone({set("xmin")}));
  EXPECT_NE(dofs.checksum, checksum_alone({set("xmax")}));
}

Fixed word(const std::string& name, std::array<bool, 3> which, const std::string& whole) {
  return {name, which, whole, whole};
}

TEST_F(DofsOfABox, LackASetWhoseNameEndsLikeComponents) {
  mesh.sets[0].name = "side:x";  // xmin
  const auto whole = number(mesh, {word("side", {true, false, false}, "side:x")});
  EXPECT_EQ(whole.total, all - 3 * 6);
  const auto named = number(mesh, {set("side:x", {false, true, false})});
  EXPECT_EQ(named.total, all - 6);
  mesh.sets[1].name = "side";
  EXPECT_THAT(
      [&] {
        number(mesh, {word("side", {true, false, false}, "side:x")});
      },
      ThrowsMessage<InputError>(
          AllOf(HasSubstr("a set 'side' and a set 'side:x'"), HasSubstr("'\"side\":x'"), HasSubstr("'\"side:x\"'"))));
  EXPECT_EQ(number(mesh, {set("side", {true, false, false})}).total, all - 6);
}

TEST_F(DofsOfABox, LackTheNodeSetOfSeveralSetsOfOneName) {
  mesh.sets[0].name = "nset:FIX";
  mesh.sets[2].name = "elset:FIX";  // ymin
  EXPECT_EQ(number(mesh, {set("FIX")}).total, all - 3 * 6);
  EXPECT_EQ(number(mesh, {set("elset:FIX")}).total, all - 3 * 8);
  mesh.sets[0].name = "surface:FIX";
  EXPECT_THAT(
      [&] { number(mesh, {set("FIX")}); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("several sets 'FIX'"), HasSubstr("'elset:FIX' or 'surface:FIX'"))));
}

TEST_F(DofsOfABox, NeverSuggestWhatWasAsked) {
  mesh.sets[0].name = "a,b";
  EXPECT_THAT(
      [&] {
        number(mesh, {{"a", {true, true, true}, "a,b"}});
      },
      ThrowsMessage<InputError>(HasSubstr("write it in double quotes, '\"a,b\"'")));
  EXPECT_THAT([&] { number(mesh, {set("ymni:up")}); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("'up' are no components"), HasSubstr("did you mean 'ymin'?"))));
}

TEST_F(DofsOfABox, LackComponents) {
  const std::vector<Fixed> supports = {set("xmin", {true, false, false}), set("zmin", {false, false, true})};
  const Dofs dofs = number(mesh, supports);
  expect_sound(mesh, dofs);
  EXPECT_EQ(dofs.total, all - 6 - 12);
  EXPECT_EQ(dofs.block, 1);
  for (int v = 0; v < mesh.local_vertices(); ++v) {
    EXPECT_EQ(dofs.fixed(v, 0), mesh.points(0, v) == 0);
    EXPECT_FALSE(dofs.fixed(v, 1));
    EXPECT_EQ(dofs.fixed(v, 2), mesh.points(2, v) == 0);
  }
  EXPECT_EQ(dofs.checksum, checksum_alone(supports));
}

TEST_F(DofsOfABox, CountOverlapsOnce) {
  const Dofs dofs = number(mesh, {set("xmin"), set("ymin"), set("xmin")});
  EXPECT_EQ(dofs.total, all - 3 * (6 + 8 - 2));
}

TEST_F(DofsOfABox, LackACoordinateBox) {
  const Fixed corner{Region3{{2.5, -infinite, -infinite}, {infinite, 1, infinite}}, {true, true, true}, "box:"};
  const Dofs dofs = number(mesh, {corner});
  expect_sound(mesh, dofs);
  EXPECT_EQ(dofs.total, all - 3 * 4);
}

TEST_F(DofsOfABox, AreFixedWhereTheFileSaysSo) {
  FileMesh file = file_of_box(text);
  file.supports = {{file.sets[0].vertices, {true, true, true}}, {{5}, {false, true, false}}};
  const Mesh read = distributed(file);
  EXPECT_EQ(number(read, {}, FileSupports::used).total, all - 18 - 1);
  EXPECT_EQ(number(read, {}, FileSupports::ignored).total, all);
  EXPECT_EQ(number(read, {set("ymin")}, FileSupports::ignored).total, all - 3 * 8);
}

TEST_F(DofsOfABox, GoToVerticesAndBack) {
  const Dofs dofs = number(mesh, {set("xmin", {true, false, true})});
  algebra::Tall x(dofs.owned, 2);
  for (int i = 0; i < dofs.owned; ++i) x.row(i) << static_cast<double>(dofs.first + i) + 1, -1;
  const algebra::Tall u = to_vertices(mesh, dofs, x);
  ASSERT_EQ(u.rows(), 3 * mesh.owned);
  for (int v = 0; v < mesh.owned; ++v)
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(u(3 * v + c, 0), dofs.fixed(v, c) ? 0 : static_cast<double>(dofs.number(v, c)) + 1);
  EXPECT_EQ(from_vertices(mesh, dofs, u), x);
}

TEST_F(DofsOfABox, ErrorsSayWhichSupport) {
  EXPECT_THAT([&] { number(mesh, {set("xmni")}); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("-fix xmni"), HasSubstr("'xmin'"))));
  const Fixed away{Region3{{7, 7, 7}, {8, 8, 8}}, {true, true, true}, "box:7,8,7,8,7,8"};
  EXPECT_THAT([&] { number(mesh, {away}); }, ThrowsMessage<InputError>(HasSubstr("box:7,8,7,8,7,8")));
  EXPECT_THAT([&] { number(mesh, {set("body")}); }, ThrowsMessage<InputError>(HasSubstr("nothing is left")));
  FileMesh held = file_of_box(text);
  held.supports = {{std::vector<Index>(held.points.size()), {true, true, true}}};
  std::iota(held.supports[0].vertices.begin(), held.supports[0].vertices.end(), Index{0});
  const Mesh fixed = distributed(held);
  EXPECT_THAT([&] { number(fixed, {}, FileSupports::used); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("*BOUNDARY"), HasSubstr("-fix replaces"))));
  Mesh empty = distributed(tetrahedra({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}));
  EXPECT_THAT([&] { number(empty, {set("foot")}); }, ThrowsMessage<InputError>(HasSubstr("no named sets")));
}

}  // namespace
}  // namespace ritz::mesh
