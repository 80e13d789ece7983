// Meshes that nobody here wrote, with eigenvalues computed elsewhere. Skipped where the data is absent.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "ritz/algebra/check.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

namespace fs = std::filesystem;

const fs::path shared = RITZ_SHARED;

fem::Materials own_materials(const mesh::Mesh& mesh) {
  fem::Materials materials;
  for (const auto& [name, m, parts, overlap] : mesh.regions)
    materials.push_back(test::stvk(m.young.value_or(1e6), m.poisson.value_or(.3), m.density.value_or(1000)));
  return materials;
}

/// A Vega mesh held at the vertices of its .bou file; free without one.
Problem vega(const std::string& mesh_name, const std::string& held) {
  mesh::Source source;
  source.mesh = shared / "models" / mesh_name;
  std::vector<mesh::Fixed> supports;
  if (!held.empty()) {
    source.vertex_lists = {shared / "models" / held};
    supports = {fixed(source.vertex_lists.front().string())};
  }
  mesh::Mesh mesh = mesh::read(MPI_COMM_WORLD, source);
  const auto materials = own_materials(mesh);
  return problem(std::move(mesh), supports, materials);
}

void expect_eigenvalues(const Problem& p, const std::vector<double>& expected) {
  const Eigen::VectorXd lambda = flexible(modes(p, static_cast<int>(expected.size())).modes);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(lambda[static_cast<Eigen::Index>(i)] / expected[i], 1, 1e-8) << "mode " << i + 1;
}

class Known : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(shared / "models" / "beam3_tet.veg")) GTEST_SKIP() << "the shared models are not here";
  }
};

TEST_F(Known, Beam3) {
  expect_eigenvalues(vega("beam3_tet.veg", "beam3.bou"),
                     {98.9101403187, 230.625992434, 3607.88679476, 7582.20534951, 13706.6597878, 25096.4000765,
                      26159.6199308, 48083.8118344, 87016.6688375, 122393.513644});
}

TEST_F(Known, Beam3Trace) {
  const Problem p = vega("beam3_tet.veg", "");
  PetscScalar trace = 0;
  algebra::check(MatGetTrace(p.matrices.stiffness, &trace));
  EXPECT_NEAR(trace / 896551724.137936, 1, 1e-14);
}

TEST_F(Known, SimpleBridge) {
  expect_eigenvalues(vega("simpleBridge_tet.veg", "simpleBridge_tet.bou"),
                     {1.86261030454, 9.05372370813, 18.2578682806, 25.0029654167, 27.9561170865, 92.8682647333,
                      105.225040545, 156.841189082, 169.747904899, 201.467925015});
}

/// The row of frequencies.csv for the exact consistent mass whose supports begin with `word`, Hz.
std::vector<double> reference(const std::string& word) {
  std::ifstream file(shared / "verification/tet4_cantilever/frequencies.csv");
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells[1].rfind(word, 0) != 0 || cells[2] != "exact consistent") continue;
    std::vector<double> values;
    for (std::size_t i = 4; i < cells.size(); ++i) values.push_back(std::stod(cells[i]));
    return values;
  }
  return {};
}

class Tet4Cantilever : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!fs::exists(shared / "verification/tet4_cantilever/frequencies.csv"))
      GTEST_SKIP() << "the shared data is not here";
  }

  void expect_frequencies(const std::string& word, const std::vector<mesh::Fixed>& supports) {
    mesh::Source source;
    source.mesh = shared / "verification/tet4_cantilever" / GetParam();
    const Problem p = problem(mesh::read(MPI_COMM_WORLD, source), supports);
    const auto expected = reference(word);
    ASSERT_EQ(expected.size(), 10u);
    const Eigen::VectorXd f = frequencies(modes(p, 10).modes);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(f[static_cast<Eigen::Index>(i)] / expected[i], 1, 1e-7) << "mode " << i + 1;
  }
};

TEST_P(Tet4Cantilever, Clamped) { expect_frequencies("clamped", {fixed("clamp")}); }
TEST_P(Tet4Cantilever, Free) { expect_frequencies("free", {}); }

INSTANTIATE_TEST_SUITE_P(, Tet4Cantilever,
                         testing::Values("cantilever.inp", "cantilever.v22.msh", "cantilever.v41.msh"),
                         [](const auto& info) { return "file_" + std::to_string(info.index); });

}  // namespace
}  // namespace ritz::test
