// The smallest problems: one cell, more ranks than cells, one free vertex, as many modes as there are, none.
#include <gtest/gtest.h>

#include "ritz/base/error.hpp"
#include "support/dense_algebra.hpp"
#include "support/lattice_mesh.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

/// A single cell: the first of a lattice hexahedron's.
mesh::FileMesh one_cell(fem::CellType type) {
  mesh::FileMesh mesh = lattice_mesh({{0, 0, 0}}, type, stretched({1, 1, 1}, {.2, .3, .25}));
  const auto vertices = static_cast<std::size_t>(fem::shape(type).vertices);
  mesh.cell_types.resize(1);
  mesh.cell_ids.resize(1);
  mesh.cell_regions.resize(1);
  mesh.cell_offsets.resize(2);
  mesh.cell_vertices.resize(vertices);
  mesh.points.resize(vertices);  // a cell's vertices are numbered as they come
  mesh.vertex_ids.resize(vertices);
  return mesh;
}

/// All flexible eigenvalues agree with the dense solver's, to ε times the largest.
void expect_dense(const Problem& p, const stages::ModesResult& result) {
  const Eigen::VectorXd all = dense_modes(p).values;
  const Eigen::VectorXd lambda = flexible(result.modes);
  ASSERT_LE(result.modes.eigenvalues.size(), all.size());
  for (Eigen::Index i = 0; i < lambda.size(); ++i)
    EXPECT_NEAR(lambda[i], all[rigid_count(result.modes) + i], 1e-12 * all.maxCoeff()) << "mode " << i + 1;
}

/// A wedge alone twists about its axis without a force.
std::vector<fem::CellType> stiff_alone() {
  std::vector<fem::CellType> types(fem::cell_types.begin(), fem::cell_types.end());
  std::erase(types, fem::CellType::wedge6);
  return types;
}

TEST(Tiny, OneWedgeIsAMechanismThatIsRefused) {
  EXPECT_THROW(modes(problem(distributed(one_cell(fem::CellType::wedge6)), {}), 100), NumericalError);
}

TEST(Tiny, OneCellHasAllItsModes) {
  for (const auto type : stiff_alone()) {
    SCOPED_TRACE(fem::shape(type).name);
    const Problem p = problem(distributed(one_cell(type)), {});
    const auto result = modes(p, 100);
    EXPECT_EQ(rigid_count(result.modes), 6);
    EXPECT_EQ(result.modes.eigenvalues.size(), 3 * fem::shape(type).vertices);
    expect_dense(p, result);
  }
}

TEST(Tiny, OneCellHasAsManyModesAsAskedFor) {
  for (const auto type : stiff_alone()) {
    SCOPED_TRACE(fem::shape(type).name);
    const Problem p = problem(distributed(one_cell(type)), {});
    expect_dense(p, modes(p, 3));
  }
}

TEST(Tiny, BoxOfTwoCells) {
  const Problem p = problem(box("box:1,.4,.3/2,1,1/hex8"), {fixed("xmin")});
  const auto result = modes(p, 1000);
  EXPECT_EQ(result.modes.eigenvalues.size(), p.dofs.total);
  expect_dense(p, result);
}

TEST(Tiny, OneFreeVertex) {
  auto whole = one_cell(fem::CellType::tet4);
  whole.sets.push_back({"held", {0, 1, 2}, {}});
  const Problem p = problem(distributed(whole), {fixed("held")});
  for (const int k : {1, 2, 3, 4, 20}) {
    const auto result = modes(p, k);
    EXPECT_EQ(rigid_count(result.modes), 0);
    EXPECT_GE(result.modes.eigenvalues.size(), std::min(k, 3));
    expect_dense(p, result);
  }
}

TEST(Tiny, OneFreeComponent) {
  auto whole = one_cell(fem::CellType::tet4);
  whole.sets.push_back({"held", {0, 1, 2}, {}});
  whole.sets.push_back({"guided", {3}, {}});
  const Problem p = problem(distributed(whole), {fixed("held"), fixed("guided", {true, false, true})});
  const auto result = modes(p, 5);
  EXPECT_EQ(result.modes.eigenvalues.size(), 1);
  expect_dense(p, result);
}

TEST(Tiny, NothingFreeIsRefused) {
  auto whole = one_cell(fem::CellType::tet4);
  whole.sets.push_back({"held", {0, 1, 2, 3}, {}});
  EXPECT_THROW(problem(distributed(whole), {fixed("held")}), InputError);
}

TEST(Tiny, NoModesWanted) {
  const auto free = modes(problem(box("box:1,.4,.3/2,1,1/tet4"), {}), 0);
  EXPECT_EQ(free.modes.eigenvalues.size(), 6);
  EXPECT_EQ(rigid_count(free.modes), 6);
  EXPECT_EQ(modes(problem(box("box:1,.4,.3/2,1,1/tet4"), {fixed("xmin")}), 0).modes.eigenvalues.size(), 0);
}

}  // namespace
}  // namespace ritz::test
