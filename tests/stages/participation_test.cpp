// Participation and effective masses: how much of the body's mass each mode carries in each direction.
#include <gtest/gtest.h>

#include "ritz/stages/projection.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

model::Inertia inertia_of(const Problem& p, const stages::ModesResult& result) {
  return stages::inertia(p.mesh, p.matrices.scalar_mass, mesh::to_vertices(p.mesh, p.dofs, result.vectors));
}

constexpr double mass = .1 * .06 * 1000;  // kg, of the block 1 x 0.10 x 0.06 m

TEST(Participation, OfAFreeBodyIsAllInItsRigidModes) {
  for (const char* mesh : {"box:1,.1,.06/6,1,1/tet10", "box:1,.1,.06/6,2,1/hex8"}) {
    const Problem p = problem(box(mesh), {});
    const auto inertia = inertia_of(p, modes(p, 8));
    const Eigen::MatrixXd effective = inertia.effective_masses();
    EXPECT_NEAR(inertia.mass() / mass, 1, 1e-13);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(effective.topRows(6).col(d).sum() / mass, 1, 1e-12);
    EXPECT_LE(effective.bottomRows(effective.rows() - 6).maxCoeff(), 1e-12 * mass);
    // The rotations hold the tensor of inertia: Σ (ψᵀMr)² over the rigid modes is rᵀMr.
    const Eigen::MatrixXd turns = inertia.rigid_coupling().topRows(6).rightCols(3);
    EXPECT_LE((turns.transpose() * turns - inertia.tensor()).cwiseAbs().maxCoeff(), 1e-12 * inertia.tensor().trace());
  }
}

TEST(Participation, OfAClampedBodyGrowsTowardsItsMass) {
  const Problem p = problem(box("box:1,.1,.06/6,1,1/tet4"), {fixed("xmin")});
  double before = 0;
  for (const int k : {3, 10, 40, 1000}) {
    const Eigen::RowVector3d sums = inertia_of(p, modes(p, k)).effective_masses().colwise().sum();
    EXPECT_LE(sums.maxCoeff(), mass * (1 + 1e-12));
    EXPECT_GE(sums.minCoeff(), before);
    before = sums.minCoeff() * (1 - 1e-12);
  }
  EXPECT_GT(before, .85 * mass);  // the rest is at the supports
}

TEST(Participation, OfBeamsFirstModesIsThatOfBeamTheory) {
  // Effective masses of an Euler-Bernoulli cantilever: 0.6131 and 0.1883 of the mass (Blevins 1979).
  const Problem p = problem(box("box:1,.02,.01/16,1,1/tet10"), {fixed("xmin")});
  const Eigen::MatrixXd effective = inertia_of(p, modes(p, 4)).effective_masses() / (.02 * .01 * 1000);
  EXPECT_NEAR(effective(0, 2), .6131, .003);
  EXPECT_NEAR(effective(1, 1), .6131, .003);
  EXPECT_NEAR(effective.col(2).segment(2, 1).sum(), .1883, .003);
}

}  // namespace
}  // namespace ritz::test
