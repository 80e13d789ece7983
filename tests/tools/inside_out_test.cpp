// Cells that a motion turns inside out are counted, and named when a run ends.
#include "ritz/tools/run_body.hpp"

#include <gmock/gmock.h>

#include "tools/run_support.hpp"

namespace ritz::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Of the sample's tetrahedron, whose vertex 0 is lifted: det(I + ∇u) = 1 − height.
std::int64_t lifted(const model::Geometry& geometry, double height) {
  model::Points u = model::Points::Zero(4, 3);
  u(0, 2) = height;
  return inside_out(geometry, u);
}

TEST(InsideOut, CountsCells) {
  auto geometry = test::sample_geometry();
  EXPECT_EQ(lifted(geometry, .99), 0);
  EXPECT_EQ(lifted(geometry, 1.01), 1);
  geometry.cells = {{10, 10}, {0, 4, 8}, {0, 1, 2, 3, 0, 1, 2, 3}};
  EXPECT_EQ(lifted(geometry, 1.01), 2);
}

TEST(InsideOut, DoesNotCountFaces) {
  auto geometry = test::sample_geometry();
  geometry.cells = {{5}, {0, 3}, {0, 1, 2}};
  EXPECT_EQ(lifted(geometry, 1.01), 0);
}

TEST(InsideOut, IsSaidAtTheEndOfARun) {
  const test::RunFolder folder;
  const auto said = [&](double force) {
    return test::run(
        folder.prepare("[static]\nsteps = 1\n[[load]]\nvertex = 10\ntotal = [0, 0, " + std::to_string(force) + "]\n"));
  };
  EXPECT_THAT(said(7), Not(HasSubstr("inside out")));  // 8 N lift the left mass by 1 m
  EXPECT_THAT(said(9), HasSubstr("1 cell is inside out at the end"));
}

}  // namespace
}  // namespace ritz::tools
