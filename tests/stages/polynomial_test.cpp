// The reduced polynomial against the full model, and witnesses that notice when something is wrong.
#include <gtest/gtest.h>

#include <limits>

#include "ritz/base/error.hpp"
#include "ritz/base/random.hpp"
#include "ritz/runtime/polynomial_force.hpp"
#include "ritz/stages/internal_force.hpp"
#include "ritz/stages/reduce_polynomial.hpp"
#include "ritz/stages/witness.hpp"
#include "support/reduction.hpp"

namespace ritz::test {
namespace {

using algebra::Tall;
using Eigen::Index;

struct PolynomialCase {
  const char* mesh;
  bool free, two;
};

class Polynomial : public testing::TestWithParam<PolynomialCase> {
 protected:
  const Reduced r = reduced(box_of(std::string("box:1,.4,.3/") + GetParam().mesh, GetParam().free, GetParam().two), 4);
  const Tall U = basis_of(r, {.modes = {}, .derivatives = 4, .cut = {.size = 7, .tolerance = 1e-12}}).U;
  const Tall u = mesh::to_vertices(r.p.mesh, r.p.dofs, U);
  const MPI_Comm comm = r.p.mesh.comm;
  const model::Polynomial polynomial = stages::reduce_polynomial(r.p, *stages::polynomial_laws(r.p.materials), u);

  Eigen::VectorXd sample(int decade) const {
    Eigen::VectorXd z(U.cols());
    for (Index i = 0; i < z.size(); ++i) z[i] = uniform(5, static_cast<std::uint64_t>(i));
    return std::pow(10.0, decade) * z;
  }
  stages::PolynomialErrors witness(const model::Polynomial& q) const { return stages::polynomial_witness(r.p, u, q); }
};

TEST_P(Polynomial, IsTheFullModelOverNineDecades) {
  const auto forces = runtime::make_polynomial_force<double>(polynomial);
  auto at = runtime::make_evaluation(forces);
  stages::Tangent tangent = stages::empty_tangent(r.p);
  for (int decade = -6; decade < 3; ++decade) {
    const Eigen::VectorXd z = sample(decade);
    const Tall displaced = u * z;
    const auto full = stages::internal_forces(r.p.mesh, r.p.materials, displaced);
    const Eigen::VectorXd force = algebra::inner(comm, u, full.forces);
    stages::fill_tangent(tangent, r.p, Eigen::VectorXd::Ones(1), displaced);
    const Eigen::MatrixXd K = algebra::inner(comm, U, algebra::multiply(tangent.matrix, U));
    runtime::evaluate<double>(forces, z, at);
    EXPECT_NEAR(at.energy / full.energies[0], 1, 1e-11) << decade;
    EXPECT_LE((at.force - force).norm(), 1e-11 * force.norm()) << decade;
    EXPECT_LE((at.tangent - K).norm(), 1e-11 * K.norm()) << decade;
  }
}

TEST_P(Polynomial, PassesItsWitness) {
  const auto [force, energy, stiffness] = witness(polynomial);
  EXPECT_LE(force, 1e-11);
  EXPECT_LE(energy, 1e-11);
  EXPECT_LE(stiffness, 1e-11);
}

TEST_P(Polynomial, IsCaughtWhenItIsSpoiled) {
  for (const auto part : {&model::Polynomial::quadratic, &model::Polynomial::cubic, &model::Polynomial::quartic}) {
    model::Polynomial spoiled = polynomial;
    Index largest = 0;
    (spoiled.*part).cwiseAbs().maxCoeff(&largest);
    (spoiled.*part)[largest] *= 1 + 1e-6;
    EXPECT_THROW(witness(spoiled), NumericalError);
    (spoiled.*part)[largest] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(witness(spoiled), NumericalError);
  }
}

INSTANTIATE_TEST_SUITE_P(
    , Polynomial,
    testing::Values(PolynomialCase{"4,2,2/tet4", false, true}, PolynomialCase{"4,2,2/tet4", true, false},
                    PolynomialCase{"3,1,1/tet10", false, true}, PolynomialCase{"3,1,1/tet10", true, false},
                    PolynomialCase{"4,2,2/hex8", false, false}, PolynomialCase{"4,2,2/hex8", true, true}),
    [](const auto& info) {
      const std::string text = info.param.mesh;
      return text.substr(text.rfind('/') + 1) + (info.param.free ? "_free" : "_clamped");
    });

}  // namespace
}  // namespace ritz::test
