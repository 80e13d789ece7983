// The estimate of what linear cells add to frequencies, against quadratic cells on the same lattice.
#include <gtest/gtest.h>

#include "ritz/stages/linear_cells.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

struct Body {
  const char* size;
  std::vector<mesh::Fixed> supports;
};

Problem of(const Body& body, const std::string& cells) {
  return problem(box(std::string("box:") + body.size + "/" + cells), body.supports);
}

double estimate(const Problem& p, const stages::ModesResult& found) {
  const auto u = mesh::to_vertices(p.mesh, p.dofs, stages::flexible_modes(found));
  return stages::linear_cells_errors(p, flexible(found.modes), u)[0].frequency;
}

std::vector<std::string> warning(const Problem& p, const stages::ModesResult& found) {
  return stages::linear_cells_warning(p, found);
}

const Body cantilever = {"1,.1,.06", {fixed("xmin")}}, free_beam = {"1,.1,.06", {}},
           plate = {"1,1,.03", {fixed("xmin"), fixed("xmax")}}, block = {"1,.9,.8", {fixed("xmin")}},
           bar = {"1,.1,.1", {fixed("xmin"), fixed("ymin", {false, true, false}), fixed("zmin", {false, false, true})}};

TEST(LinearCells, WhatBendsIsWarnedOfAndItsErrorEstimated) {
  for (const auto& [body, layers] : {std::pair{cantilever, "20,2,1"},
                                     {cantilever, "20,2,2"},
                                     {free_beam, "20,2,2"},
                                     {plate, "8,8,1"},
                                     {plate, "8,8,2"}})
    for (const std::string type : {"/tet4", "/hex8"}) {
      const Problem p = of(body, layers + type), q = of(body, layers + std::string("/tet10"));
      const auto found = modes(p, 3);
      const double error = frequencies(found.modes)[0] / frequencies(modes(q, 3).modes)[0] - 1;
      EXPECT_EQ(warning(p, found).size(), 1u) << body.size << ' ' << layers << type << " is off by " << error;
      EXPECT_GT(estimate(p, found), .2 * error) << body.size << ' ' << layers << type;
      EXPECT_LT(estimate(p, found), error + .03) << body.size << ' ' << layers << type;
    }
}

TEST(LinearCells, ThickBlocksStretchingBarsAndQuadraticCellsAreNot) {
  for (const auto& [body, cells] : {std::pair{block, "5,5,5/tet4"},
                                    {block, "4,4,4/hex8"},
                                    {bar, "10,1,1/tet4"},
                                    {bar, "10,1,1/hex8"},
                                    {cantilever, "20,2,1/tet10"},
                                    {plate, "4,4,1/tet10"}}) {
    const Problem p = of(body, cells);
    EXPECT_EQ(warning(p, modes(p, 3)), std::vector<std::string>()) << body.size << ' ' << cells;
  }
}

TEST(LinearCells, AJumpOfStiffnessIsNoError) {
  mesh::Mesh halves = box("box:1,.1,.1/10,1,1/hex8");
  halves.regions.push_back({"stiff", {}});
  for (int c = 0; c < halves.cells.count(); ++c)
    halves.cells.regions[static_cast<std::size_t>(c)] = halves.corners(c).row(0).mean() > .5;
  const fem::Material soft_half = test::stvk(1e6, 0, 1000), stiff_half = test::stvk(1e8, 0, 1000);
  const Problem p = problem(std::move(halves), bar.supports, {soft_half, stiff_half});
  EXPECT_LT(estimate(p, modes(p, 1)), .02);
}

}  // namespace
}  // namespace ritz::test
