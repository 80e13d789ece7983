// Equilibria of the full model against closed forms and the elastica.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <tuple>

#include "ritz/base/error.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/full_loads.hpp"
#include "support/full_runs.hpp"

namespace ritz::test {
namespace {

constexpr double E = 1e5, nu = .3;
constexpr fem::Material rubber = test::stvk(E, nu, 1000);

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

// At the stretch 1.5, as solved for beforehand.
TEST_P(Uniaxial, StressStretchesABarOfAnotherLaw) {
  const std::vector<mesh::Fixed> rollers = {fixed("xmin", {1, 0, 0}), fixed("ymin", {0, 1, 0}),
                                            fixed("zmin", {0, 0, 1})};
  FullRun run{problem(box(std::string("box:2,1,1/3,2,2/") + GetParam()), rollers, neo_hookean({rubber}))};
  const Eigen::Vector3d traction(3.7828017639e4, 0, 0);
  const auto u = run.statics(run.free(stages::traction_force(run.p.mesh, *run.p.mesh.find("xmax"), traction)), 1);
  EXPECT_NEAR(run.mean(u, "xmax").x(), 2 * .5, 1e-9);
  EXPECT_NEAR(run.mean(u, "ymax").y(), .880174591807 - 1, 1e-9);
}

// Between walls pressed to two fifths of its length in one step: Newton's first step turns cells inside out, of which
// the law knows nothing, so that the increment is halved.
TEST_P(Uniaxial, StrainOfAnotherLawHasNoLimitPoint) {
  const std::vector<mesh::Fixed> walls = {fixed("xmin"),
                                          fixed("xmax", {0, 1, 1}),
                                          fixed("ymin", {0, 1, 0}),
                                          fixed("ymax", {0, 1, 0}),
                                          fixed("zmin", {0, 0, 1}),
                                          fixed("zmax", {0, 0, 1})};
  FullRun run{problem(box(std::string("box:2,1,1/3,2,2/") + GetParam()), walls, neo_hookean({rubber}))};
  const auto P = fem::NeoHookean{E, nu}.response(Eigen::Vector3d(-.6, 0, 0).asDiagonal()).stress;
  ASSERT_LT(P(0, 0) / (rubber.at_rest().lambda + 2 * rubber.at_rest().mu), -1);  // what the first step would strain
  const Eigen::Vector3d traction(P(0, 0), 0, 0);
  const auto u = run.statics(run.free(stages::traction_force(run.p.mesh, *run.p.mesh.find("xmax"), traction)), 1);
  EXPECT_NEAR(run.mean(u, "xmax").x(), 2 * -.6, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Cells, Uniaxial, testing::Values("tet4", "tet10", "hex8", "hex20", "wedge6", "wedge15"),
                         [](const auto& info) { return std::string(info.param); });

TEST(FullStatics, RefusesABodyThatIsNotHeld) {
  FullRun run{problem(box("box:1,1,1/1,1,1/hex8"), {}, {rubber})};
  EXPECT_THROW(run.statics(run.zeros(), 1), InputError);
}

TEST(FullStatics, ARigidRotationHasNoForce) {
  FullRun run{problem(box("box:1,.5,.4/3,2,2/tet10"), {}, {rubber})};
  for (const double angle : {1e-3, .7, 3.0}) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -2) / 3).toRotationMatrix();
    algebra::Tall u(3 * run.p.mesh.owned, 1);
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
  FullRun run{problem(box("box:1,.02,.02/25,1,1/tet10"), {fixed("xmin")}, {test::stvk(1e7, 0, 1000)})};
  const mesh::Set& end = *run.p.mesh.find("xmax");
  for (const auto& [load, u, w] : {std::tuple{.5, .01592, .16214},
                                   {1., .05643, .30172},
                                   {2., .16064, .49346},
                                   {5., .38763, .71379},
                                   {10., .55500, .81061}}) {
    const Eigen::Vector3d traction(0, 0, load * EI / (h * h));
    const auto force = run.free(stages::traction_force(run.p.mesh, end, traction));
    const auto tip = run.mean(run.statics(force, 1 + static_cast<int>(load / 2)), "xmax");
    EXPECT_NEAR(-tip.x() / u, 1, .01) << load;
    EXPECT_NEAR(tip.z() / w, 1, .01) << load;
  }
}

// A moment t EI/L at the end bends the beam into a circle's arc of angle t: the end moves by L (sin t/t − 1) and
// L/t (1 − cos t). The moment turns with the end: a couple of forces along x on the straight beam, turned by t.
TEST(FullStatics, AnEndMomentClosesTheCircle) {
  const double h = .02, EI = 1e7 * h * h * h * h / 12, pi = 4 * std::atan(1.0);
  const std::vector<mesh::Fixed> in_plane = {fixed("xmin"), fixed("ymin", {0, 1, 0}), fixed("ymax", {0, 1, 0})};
  FullRun run{problem(box("box:1,.02,.02/40,1,1/tet10"), in_plane, {test::stvk(1e7, 0, 1000)})};
  const mesh::Set& end = *run.p.mesh.find("xmax");
  double arms = 0;  // Σ z² over the end's vertices: forces in proportion to z make the moment
  for (const int v : end.vertices)
    if (v < run.p.mesh.owned) arms += std::pow(run.p.mesh.points(2, v) - h / 2, 2);
  arms = parallel::sum(run.p.mesh.comm, arms);
  const auto moment = [&](double t) {
    algebra::Tall force = algebra::Tall::Zero(3 * run.p.mesh.owned, 1);
    for (const int v : end.vertices)
      if (v < run.p.mesh.owned)
        force.col(0).segment<3>(3 * v) =
            -t * EI * (run.p.mesh.points(2, v) - h / 2) / arms * Eigen::Vector3d(std::cos(t), 0, std::sin(t));
    return run.free(force);
  };
  for (const auto& [t, u, v] : {std::tuple{pi / 2, 2 / pi - 1, 2 / pi}, {2 * pi, -1., 0.}}) {
    stages::StaticState last{0, run.zeros(), 0};
    stages::full_statics(
        run.model, {.steps = static_cast<int>(std::round(8 * t / pi))}, last,
        [&, angle = t](double fraction) { return moment(fraction * angle); },
        [&](const stages::StaticState& now, const stages::StaticReport&) { last = now; });
    const auto tip = run.mean(last.u, "xmax");
    EXPECT_NEAR(tip.x(), u, .01 * std::abs(u)) << t;
    EXPECT_NEAR(tip.z(), v, .01 * (v > 0 ? v : 1)) << t;
  }
}

}  // namespace
}  // namespace ritz::test
