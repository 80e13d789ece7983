// Equilibria of the full model against those that another program found on the shared mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "ritz/base/shown.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/full_loads.hpp"
#include "support/full_runs.hpp"
#include "support/statics.hpp"

namespace ritz::test {
namespace {

namespace fs = std::filesystem;

/// The numbers of a table with a header, by the first in a row; words count as 0.
std::map<double, std::vector<double>> read_table(const fs::path& path, std::size_t key) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  std::map<double, std::vector<double>> rows;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::vector<double> row;
    for (std::string word; std::getline(words, word, ',');) row.push_back(std::strtod(word.c_str(), nullptr));
    rows[row[key]] = row;
  }
  return rows;
}

Eigen::Vector3d vector_at(const std::vector<double>& row, std::size_t first) {
  return {row[first], row[first + 1], row[first + 2]};
}

/// The cantilever of the shared data, and what CalculiX, whose *ELASTIC with NLGEOM is StVK, found on it.
class CalculiX : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(folder)) GTEST_SKIP() << "the shared verification data is not here";
  }

  static FullRun cantilever() {
    mesh::Source source;
    source.mesh = folder / "cantilever.v41.msh";
    return {problem(mesh::read(MPI_COMM_WORLD, source), {fixed("clamp")}, {test::stvk(1e6, .3, 1000)})};
  }
  static algebra::Tall end_load(const FullRun& run, double p) {
    return run.free(stages::shared_force(run.p.mesh, *run.p.mesh.find("tip"), {0, 0, -1.8 * p}));
  }

  inline static const fs::path folder = fs::path(RITZ_SHARED) / "verification/tet4_cantilever";
};

TEST_F(CalculiX, AgreesAtTheTipAndAtEveryVertex) {
  FullRun run = cantilever();
  const auto tips = read_table(folder / "static_tip.csv", 1);
  EXPECT_EQ(tips.size(), 5U);
  int tables = 0;
  for (const auto& [p, tip] : tips) {
    SCOPED_TRACE("load " + shown(p));
    const auto u = run.statics(end_load(run, p), 1 + static_cast<int>(p / 2));
    const algebra::Tall all = mesh::to_vertices(run.p.mesh, run.p.dofs, u);
    const auto at = [&](int v) -> Eigen::Vector3d { return all.col(0).segment<3>(3 * v); };
    double largest = 0;
    for (int v = 0; v < run.p.mesh.owned; ++v) largest = std::max(largest, at(v).norm());
    const double gate = 1e-6 * parallel::max(run.p.mesh.comm, largest);
    EXPECT_LE((run.mean(u, "tip") - vector_at(tip, 4)).norm(), gate);

    const fs::path file = folder / ("static_p" + shown(p) + "_all_vertices.csv");
    const auto everywhere = fs::exists(file) ? read_table(file, 0) : std::map<double, std::vector<double>>{};
    tables += everywhere.empty() ? 0 : 1;
    std::int64_t corners = 0;
    for (int v = 0; v < run.p.mesh.owned; ++v) {
      const auto id = static_cast<double>(run.p.mesh.ids[static_cast<std::size_t>(v)]);
      if (id == tip[7]) {
        ++corners;
        EXPECT_LE((at(v) - vector_at(tip, 8)).norm(), gate);
      }
      if (!everywhere.empty()) {
        EXPECT_LE((at(v) - vector_at(everywhere.at(id), 1)).norm(), gate) << "vertex " << id;
      }
    }
    EXPECT_EQ(parallel::sum(run.p.mesh.comm, corners), 1);
  }
  EXPECT_EQ(tables, 3);
}

TEST_F(CalculiX, AgreesWithoutLargeDisplacements) {
  const FullRun run = cantilever();
  for (const auto& [p, tip] : read_table(folder / "static_tip.csv", 1)) {
    const auto mean = run.mean(solve(run.p, end_load(run, p)), "tip");
    EXPECT_NEAR(mean.x(), tip[11], 1e-6 * std::abs(tip[12])) << "load " << p;
    EXPECT_NEAR(mean.z(), tip[12], 1e-6 * std::abs(tip[12])) << "load " << p;
  }
}

}  // namespace
}  // namespace ritz::test
