// The tangent stiffness of the full model against assemble's, against differences of forces, and against itself.
#include <gtest/gtest.h>

#include "ritz/stages/canonical.hpp"
#include "ritz/stages/full_model.hpp"
#include "support/problem.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;

struct Filled {
  Problem p;
  stages::FullModel model = stages::full_model(p, algebra::LinearSolver::direct);

  /// K(u), u over free degrees of freedom.
  Eigen::MatrixXd at(const Tall& u) {
    stages::fill_tangent(model.tangent, p, Eigen::VectorXd::Ones(u.cols()), mesh::to_vertices(p.mesh, p.dofs, u));
    return dense(model.tangent.matrix);
  }
};

class Tangent : public testing::TestWithParam<const char*> {
 protected:
  Filled f{problem(box(std::string("box:1,.5,.4/3,2,2/") + GetParam()), {fixed("xmin"), fixed("ymax", {0, 0, 1})})};
  const Tall psi = .02 * stages::fixed_vectors(f.p.mesh, f.p.dofs, 1, 5);
};

TEST_P(Tangent, AtRestIsTheStiffness) {
  const Eigen::MatrixXd K = dense(f.p.matrices.stiffness);
  EXPECT_LE((f.at(0 * psi) - K).cwiseAbs().maxCoeff(), 1e-14 * K.cwiseAbs().maxCoeff());
}

TEST_P(Tangent, IsTheDerivativeOfTheForce) {
  const Tall direction = stages::fixed_vectors(f.p.mesh, f.p.dofs, 1, 6);
  const Eigen::MatrixXd K = f.at(psi);
  const auto force = [&](double s) { return stages::energy_and_force(f.model, psi + s * direction).force; };
  // The force is a cubic: its central differences are its derivative and h² times a constant, which two of them tell.
  const double h = 2e-3;
  const Tall near = (force(h) - force(-h)) / (2 * h), far = (force(2 * h) - force(-2 * h)) / (4 * h);
  const Eigen::MatrixXd expected = whole(f.p.mesh.comm, (4 * near - far) / 3);
  const Eigen::MatrixXd computed = K * whole(f.p.mesh.comm, direction);
  EXPECT_LE((computed - expected).norm(), 1e-10 * expected.norm());
  EXPECT_LE((K - K.transpose()).cwiseAbs().maxCoeff(), 1e-13 * K.cwiseAbs().maxCoeff());
}

// K is quadratic in u: the odd part over ε is the same for every ε, which is the Hessian's contraction with ψ.
TEST_P(Tangent, HasAnOddPartThatIsLinear) {
  const auto odd = [&](double e) -> Eigen::MatrixXd { return (f.at(e * psi) - f.at(-e * psi)) / e; };
  const Eigen::MatrixXd one = odd(1);
  EXPECT_GT(one.norm(), 0);
  EXPECT_LE((odd(.5) - one).norm(), 1e-11 * one.norm());
}

TEST_P(Tangent, AddsUpItsColumns) {
  Tall two(psi.rows(), 2);
  two << psi, -2 * psi;
  const Eigen::MatrixXd sum = f.at(psi) + f.at(-2 * psi);
  EXPECT_LE((f.at(two) - sum).norm(), 1e-14 * sum.norm());
}

INSTANTIATE_TEST_SUITE_P(Cells, Tangent, testing::Values("tet4", "tet10", "hex8", "hex20", "wedge6", "wedge15"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace ritz::test
