// Equilibria of the full model against closed forms, the elastica, and another program.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <tuple>

#include "ritz/base/error.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/full_loads.hpp"
#include "support/full_runs.hpp"

namespace ritz::test {
namespace {

namespace fs = std::filesystem;

constexpr double E = 1e5, nu = .3;
constexpr fem::StVK rubber = {E, nu, 1000};

class Uniaxial : public testing::TestWithParam<const char*> {};

// Rollers on three faces, a dead traction on the fourth: N/A₀ = E/2 λ(λ² − 1), lateral stretch √(1 − ν(λ² − 1)).
TEST_P(Uniaxial, StressStretchesABar) {
  const std::vector<mesh::Fixed> rollers = {fixed("xmin", {1, 0, 0}), fixed("ymin", {0, 1, 0}),
                                            fixed("zmin", {0, 0, 1})};
  FullRun run{problem(box(std::string("box:2,1,1/3,2,2/") + GetParam()), rollers, {rubber})};
  for (const double stretch : {1.1, 1.6, .8}) {
    const double N = E / 2 * stretch * (stretch * stretch - 1);
    const auto u = run.statics(
        run.free(stages::traction_force(run.p.mesh, *run.p.mesh.find("xmax"), Eigen::Vector3d(N, 0, 0))), 2);
    EXPECT_NEAR(run.mean(u, "xmax").x(), 2 * (stretch - 1), 1e-10);
    EXPECT_NEAR(run.mean(u, "ymax").y(), std::sqrt(1 - nu * (stretch * stretch - 1)) - 1, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, Uniaxial, testing::Values("tet4", "tet10", "hex8"),
                         [](const auto& info) { return std::string(info.param); });

TEST(FullStatics, NamesALimitPoint) {
  const std::vector<mesh::Fixed> confined = {fixed("xmin"),
                                             fixed("xmax", {0, 1, 1}),
                                             fixed("ymin", {0, 1, 0}),
                                             fixed("ymax", {0, 1, 0}),
                                             fixed("zmin", {0, 0, 1}),
                                             fixed("zmax", {0, 0, 1})};
  FullRun run{problem(box("box:1,1,1/2,1,1/hex8"), confined, {rubber})};
  const auto press = [&](double N) {
    return run.statics(run.free(stages::traction_force(run.p.mesh, *run.p.mesh.find("xmax"), Eigen::Vector3d(N, 0, 0))),
                       4);
  };
  EXPECT_NEAR(run.mean(press(-22085.336538461539), "xmax").x(), -.25, 1e-10);
  try {
    press(-2 * 25906.74);
    ADD_FAILURE() << "went past the limit point of uniaxial strain at a stretch of 1/√3";
  } catch (const NumericalError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("load fraction 0.49"), text.npos) << text;
    EXPECT_NE(text.find("limit point"), text.npos) << text;
  }
}

TEST(FullStatics, RefusesABodyThatIsNotHeld) {
  FullRun run{problem(box("box:1,1,1/1,1,1/hex8"), {}, {rubber})};
  EXPECT_THROW(run.statics(run.zeros(), 1), InputError);
}

TEST(FullStatics, ARigidRotationHasNoForce) {
  FullRun run{problem(box("box:1,.5,.4/3,2,2/tet10"), {}, {rubber})};
  for (const double angle : {1e-3, .7, 3.0}) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -2) / 3).toRotationMatrix();
    petsc::Tall u(3 * run.p.mesh.owned, 1);
    for (int v = 0; v < run.p.mesh.owned; ++v)
      u.col(0).segment<3>(3 * v) = R * run.p.mesh.points.col(v) - run.p.mesh.points.col(v);
    const auto [energy, force] = stages::energy_and_force(run.model, run.free(u));
    EXPECT_LE(stages::norm(run.model, force), 1e-12 * E * .2) << angle;
    EXPECT_LE(std::abs(energy), 1e-20 * E);
  }
}

// Dead end load PL²/EI: the end's u/L and w/L. Poisson's ratio 0, L/h = 50.
TEST(FullStatics, FollowsTheElastica) {
  const double h = .02, EI = 1e7 * h * h * h * h / 12;
  FullRun run{problem(box("box:1,.02,.02/25,1,1/tet10"), {fixed("xmin")}, {{1e7, 0, 1000}})};
  const mesh::Set& end = *run.p.mesh.find("xmax");
  for (const auto& [load, u, w] : {std::tuple{1., .05643, .30172}, {2., .16064, .49346}, {5., .38763, .71379}}) {
    const Eigen::Vector3d traction(0, 0, load * EI / (h * h));
    const auto tip = run.mean(run.statics(run.free(stages::traction_force(run.p.mesh, end, traction)), 5), "xmax");
    EXPECT_NEAR(-tip.x() / u, 1, .01) << load;
    EXPECT_NEAR(tip.z() / w, 1, .01) << load;
  }
}

// A moment t EI/L at the end bends the beam into a circle's arc of angle t: the end moves by L (sin t/t − 1) and
// L/t (1 − cos t). The moment turns with the end: a couple of forces along x on the straight beam, turned by t.
TEST(FullStatics, AnEndMomentClosesTheCircle) {
  const double h = .02, EI = 1e7 * h * h * h * h / 12, pi = 4 * std::atan(1.0);
  const std::vector<mesh::Fixed> in_plane = {fixed("xmin"), fixed("ymin", {0, 1, 0}), fixed("ymax", {0, 1, 0})};
  FullRun run{problem(box("box:1,.02,.02/40,1,1/tet10"), in_plane, {{1e7, 0, 1000}})};
  const mesh::Set& end = *run.p.mesh.find("xmax");
  double arms = 0;  // Σ z² over the end's vertices: forces in proportion to z make the moment
  for (const int v : end.vertices)
    if (v < run.p.mesh.owned) arms += std::pow(run.p.mesh.points(2, v) - h / 2, 2);
  arms = parallel::sum(run.p.mesh.comm, arms);
  const auto moment = [&](double t) {
    petsc::Tall force = petsc::Tall::Zero(3 * run.p.mesh.owned, 1);
    for (const int v : end.vertices)
      if (v < run.p.mesh.owned)
        force.col(0).segment<3>(3 * v) =
            -t * EI * (run.p.mesh.points(2, v) - h / 2) / arms * Eigen::Vector3d(std::cos(t), 0, std::sin(t));
    return run.free(force);
  };
  for (const double t : {pi / 2, 2 * pi}) {
    stages::StaticState last{0, run.zeros(), 0};
    stages::full_statics(
        run.model, {.steps = static_cast<int>(std::round(8 * t / pi))}, last,
        [&](double fraction) { return moment(fraction * t); }, [&](const stages::StaticState& now) { last = now; });
    const auto tip = run.mean(last.u, "xmax");
    EXPECT_NEAR(tip.x(), std::sin(t) / t - 1, .01) << t;
    EXPECT_NEAR(tip.z(), (1 - std::cos(t)) / t, .01) << t;
  }
}

/// Rows "number,x,y,z" of a table with a header, by the mesh file's own number.
std::map<mesh::Index, Eigen::Vector3d> read_displacements(const fs::path& path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  std::map<mesh::Index, Eigen::Vector3d> rows;
  while (std::getline(in, line)) {
    for (char& c : line)
      if (c == ',') c = ' ';
    std::istringstream words(line);
    mesh::Index id = 0;
    Eigen::Vector3d u;
    words >> id >> u[0] >> u[1] >> u[2];
    rows[id] = u;
  }
  return rows;
}

// What CalculiX, whose *ELASTIC with NLGEOM is StVK, found on the same mesh.
TEST(FullStatics, AgreesWithCalculiX) {
  const fs::path folder = fs::path(RITZ_SHARED) / "verification/tet4_cantilever";
  if (!fs::exists(folder)) GTEST_SKIP() << "the shared verification data is not here";
  mesh::Source source;
  source.mesh = folder / "cantilever.v41.msh";
  FullRun run{problem(mesh::read(MPI_COMM_WORLD, source), {fixed("clamp")}, {{1e6, .3, 1000}})};
  for (const auto* load : {"0.5", "2", "8"}) {
    const Eigen::Vector3d P(0, 0, -1.8 * std::stod(load));
    const auto u = run.statics(run.free(stages::shared_force(run.p.mesh, *run.p.mesh.find("tip"), P)), 4);
    const petsc::Tall all = mesh::to_vertices(run.p.mesh, run.p.dofs, u);
    const auto expected = read_displacements(folder / ("static_p" + std::string(load) + "_all_vertices.csv"));
    double largest = 0;
    for (const auto& [id, x] : expected) largest = std::max(largest, x.norm());
    for (int v = 0; v < run.p.mesh.owned; ++v) {
      const Eigen::Vector3d x = expected.at(run.p.mesh.ids[static_cast<std::size_t>(v)]);
      EXPECT_LE((all.col(0).segment<3>(3 * v) - x).norm(), 1e-6 * largest) << "load " << load << ", vertex " << v;
    }
  }
}

}  // namespace
}  // namespace ritz::test
