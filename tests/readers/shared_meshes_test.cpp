// Meshes that others made, where they are at hand.
#include <gtest/gtest.h>

#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

const std::filesystem::path shared = RITZ_SHARED;

double corner_determinant(const FileMesh& mesh, std::size_t c) {
  const bool hex = mesh.cell_types[c] == fem::CellType::hex8;
  const auto x = [&](std::size_t i) {
    const auto at = static_cast<std::size_t>(mesh.cell_offsets[c]) + i;
    return mesh.points[static_cast<std::size_t>(mesh.cell_vertices[at])];
  };
  const auto o = x(0), a = x(1), b = x(hex ? 3 : 2), d = x(hex ? 4 : 3);
  const auto e = [&](const std::array<double, 3>& p, std::size_t i) { return p[i] - o[i]; };
  return e(a, 0) * (e(b, 1) * e(d, 2) - e(b, 2) * e(d, 1)) - e(a, 1) * (e(b, 0) * e(d, 2) - e(b, 2) * e(d, 0)) +
         e(a, 2) * (e(b, 0) * e(d, 1) - e(b, 1) * e(d, 0));
}

struct Known {
  const char* file;
  std::size_t vertices;
  std::size_t cells;
  fem::CellType type;
};

TEST(SharedMeshes, OfVegaAreRightHandedWithTheirMaterials) {
  if (!std::filesystem::exists(shared / "models")) GTEST_SKIP() << "no shared models";
  for (const auto& known :
       {Known{"beam3.veg", 208, 75, fem::CellType::hex8}, Known{"beam3_tet.veg", 208, 450, fem::CellType::tet4},
        Known{"simpleBridge_hex.veg", 3923, 1736, fem::CellType::hex8},
        Known{"simpleBridge_tet.veg", 4000, 12827, fem::CellType::tet4}}) {
    SCOPED_TRACE(known.file);
    const auto mesh = read_file(shared / "models" / known.file);
    EXPECT_EQ(mesh.points.size(), known.vertices);
    EXPECT_EQ(mesh.cell_types, std::vector(known.cells, known.type));
    for (std::size_t c = 0; c < known.cells; ++c) EXPECT_GT(corner_determinant(mesh, c), 0) << c;
    ASSERT_EQ(mesh.regions.size(), 1u);
    EXPECT_EQ(mesh.regions[0].material.young, 1e7);
    EXPECT_EQ(mesh.regions[0].material.poisson, 0.45);
    EXPECT_EQ(mesh.regions[0].material.density, 1000);
  }
  EXPECT_EQ(read_bou(shared / "models/beam3.bou", 208), (std::vector<Index>{50, 51, 102, 103, 154, 155, 206, 207}));
  EXPECT_EQ(read_bou(shared / "models/simpleBridge_tet.bou", 4000).size(), 121u);
}

TEST(SharedMeshes, AreTheSameInGmshsAndAbaqussFormat) {
  const auto folder = shared / "verification/tet4_cantilever";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared verification meshes";
  const auto v22 = read_file(folder / "cantilever.v22.msh");
  EXPECT_EQ(v22.points.size(), 503u);
  EXPECT_EQ(v22.cell_types.size(), 1414u);
  for (const char* const name : {"cantilever.v41.msh", "cantilever.inp"}) {
    SCOPED_TRACE(name);
    const auto other = read_file(folder / name);
    EXPECT_EQ(other.vertex_ids, v22.vertex_ids);
    EXPECT_EQ(other.cell_vertices, v22.cell_vertices);
    EXPECT_EQ(cell_region_names(other), cell_region_names(v22));
    for (std::size_t v = 0; v < v22.points.size(); ++v) {
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(other.points[v][i], v22.points[v][i], 1e-14);
    }
    for (const char* const set : {"clamp", "tip", "body"}) {
      ASSERT_TRUE(find_set(other, set));
      EXPECT_EQ(find_set(other, set)->vertices, find_set(v22, set)->vertices);
      EXPECT_EQ(find_set(other, set)->faces.size(), find_set(v22, set)->faces.size());
    }
  }
  for (const Index v : find_set(v22, "clamp")->vertices) EXPECT_EQ(v22.points[static_cast<std::size_t>(v)][0], 0);
}

}  // namespace
}  // namespace ritz::readers::testing
