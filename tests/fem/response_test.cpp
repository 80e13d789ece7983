// Cells of each element and law against closed forms, finite differences and the stiffness at rest. The forms of
// single laws are law_test's.
#include "ritz/fem/response.hpp"

#include <cmath>

#include "fem/sample_cells.hpp"
#include "ritz/fem/stiffness.hpp"

namespace ritz::fem {
namespace {

using namespace testing;

constexpr StVK stvk{1e5, .3};
const Material rubber{stvk, 1000}, neo_hookean{NeoHookean{1e5, .3}, 1000};

template <class E>
EnergyAndForce<E> response_of(const Coordinates<E>& x, const Coordinates<E>& u, const Material& material) {
  return energy_and_force<E>(integration_points<E>(x), u, material);
}
template <class E>
Eigen::MatrixXd tangent_of(const Coordinates<E>& x, const Coordinates<E>& u, const Material& material) {
  return any_size(tangent<E>(integration_points<E>(x), u, material));
}

template <class E>
class Cells : public ::testing::Test {
 protected:
  /// The displacement x ↦ (F − I) x.
  static Coordinates<E> affine(const Coordinates<E>& x, const Matrix<3, 3>& F) {
    return mapped<E>(F - Matrix<3, 3>::Identity(), x);
  }
  static Matrix<3, 3> stretched(double along, double across) { return Vector<3>(along, across, across).asDiagonal(); }

  /// P = F S over the cell, from the force's moments: ∫ P dV = Σ f_a X_aᵀ.
  static Matrix<3, 3> mean_stress(const Coordinates<E>& x, const Coordinates<E>& u, double volume) {
    return any_size(response_of<E>(x, u, rubber).force) * any_size(x).transpose() / volume;
  }
  static double rule_volume(const Coordinates<E>& x) {
    double sum = 0;
    for (const auto& point : integration_points<E>(x)) sum += point.weight;
    return sum;
  }
};

TYPED_TEST_SUITE(Cells, Elements);

TYPED_TEST(Cells, UniaxialStressIsTheClosedForm) {
  using E = TypeParam;
  const auto x = straight_cell<E>(1);
  const double volume = this->rule_volume(x);
  for (const auto& [stretch, stress] : {std::pair{1.1, 11550.0}, {1.6, 124800.0}, {2.0, 300000.0}}) {
    const double across = std::sqrt(1 - stvk.poisson * (stretch * stretch - 1));
    const auto P = this->mean_stress(x, this->affine(x, this->stretched(stretch, across)), volume);
    const Matrix<3, 3> expected = Vector<3>(stress, 0, 0).asDiagonal();
    EXPECT_LE((P - expected).norm(), 1e-12 * stress) << stretch;
  }
}

TYPED_TEST(Cells, UniaxialStrainIsTheClosedForm) {
  using E = TypeParam;
  const auto x = straight_cell<E>(2);
  const double volume = this->rule_volume(x), modulus = stvk.lambda() + 2 * stvk.mu();
  for (const double stretch : {.75, 1 / std::sqrt(3.0), 1.3}) {
    const double expected = modulus / 2 * stretch * (stretch * stretch - 1);
    EXPECT_NEAR(this->mean_stress(x, this->affine(x, this->stretched(stretch, 1)), volume)(0, 0), expected,
                1e-12 * std::abs(expected));
  }
  EXPECT_NEAR(modulus / 2 * .75 * (.75 * .75 - 1), -22085.34, .005);
}

TYPED_TEST(Cells, RotationsCostNothing) {
  using E = TypeParam;
  const auto x = curved_cell<E>(3);
  const double scale = stvk.young * std::pow(this->rule_volume(x), 2. / 3);
  for (const double angle : {.1, 1.0, 2.5, M_PI}) {
    const Matrix<3, 3> Q = Eigen::AngleAxisd(angle, Vector<3>(1, -2, .7).normalized()).toRotationMatrix();
    for (const auto& material : {rubber, neo_hookean}) {
      const auto response = response_of<E>(x, this->affine(x, Q), material);
      EXPECT_LE(any_size(response.force).norm(), 1e-12 * scale) << angle;
      EXPECT_LE(std::abs(response.energy), 1e-12 * scale) << angle;
    }
  }
}

TYPED_TEST(Cells, TangentAtRestIsTheStiffness) {
  using E = TypeParam;
  const auto x = curved_cell<E>(4);
  const auto K = any_size(stiffness<E>(x, rubber.at_rest()));
  for (const auto& material : {rubber, neo_hookean}) {
    const auto at_rest = tangent_of<E>(x, Coordinates<E>::Zero(), material);
    EXPECT_LE((at_rest - K).norm(), 1e-14 * K.norm());
  }
}

// Central differences on two scales, extrapolated: exact but for rounding where the energy is quartic.
TYPED_TEST(Cells, ForceAndTangentAreTheDerivatives) {
  using E = TypeParam;
  const auto x = curved_cell<E>(5);
  for (const auto& [material, size, error] : {std::tuple{rubber, .2, 1e-10}, {neo_hookean, .02, 1e-6}}) {
    const Eigen::MatrixXd u = size * any_size(random_matrix<3, E::vertices>(50)),
                          d = size * any_size(random_matrix<3, E::vertices>(51));
    const auto at = [&, &law = material](double t) {
      const auto response = response_of<E>(x, coordinates<E>(u + t * d), law);
      return std::pair{response.energy, any_size(response.force)};
    };
    const auto energy = [&](double h) { return (at(h).first - at(-h).first) / (2 * h); };
    const auto force = [&](double h) -> Eigen::MatrixXd { return (at(h).second - at(-h).second) / (2 * h); };
    const double slope = (4 * energy(.05) - energy(.1)) / 3;
    EXPECT_NEAR(at(0).second.cwiseProduct(d).sum(), slope, error * std::abs(slope)) << name(material.law);
    const Eigen::MatrixXd change = (4 * force(.05) - force(.1)) / 3;
    const auto K = tangent_of<E>(x, coordinates<E>(u), material);
    const Eigen::VectorXd product = K * Eigen::Map<const Eigen::VectorXd>(d.data(), d.size());
    EXPECT_LE((product - Eigen::Map<const Eigen::VectorXd>(change.data(), change.size())).norm(),
              error * product.norm())
        << name(material.law);
    EXPECT_EQ((K - K.transpose()).norm(), 0);
  }
}

TYPED_TEST(Cells, TangentsOfSeveralStatesAreSummedByTheirWeights) {
  using E = TypeParam;
  const auto x = curved_cell<E>(8);
  const Coordinates<E> u = .1 * random_matrix<3, E::vertices>(80), v = .1 * random_matrix<3, E::vertices>(81);
  const auto points = integration_points<E>(x);
  TangentSum<E> sum;
  sum.add(points, u, rubber, .3);
  sum.add(points, v, neo_hookean, -2);
  const Eigen::MatrixXd expected = .3 * tangent_of<E>(x, u, rubber) - 2 * tangent_of<E>(x, v, neo_hookean);
  EXPECT_LE((any_size(sum.matrix()) - expected).norm(), 1e-14 * expected.norm());
}

TYPED_TEST(Cells, ForcesBalance) {
  using E = TypeParam;
  const auto x = curved_cell<E>(6);
  for (const auto& [material, size] : {std::pair{rubber, .3}, {neo_hookean, .03}}) {
    const Eigen::MatrixXd u = size * any_size(random_matrix<3, E::vertices>(60)), shape = any_size(x) + u;
    const auto f = any_size(response_of<E>(x, coordinates<E>(u), material).force);
    EXPECT_LE(f.rowwise().sum().norm(), 1e-12 * f.norm());
    const Matrix<3, 3> moments = f * shape.transpose();
    EXPECT_LE((moments - moments.transpose()).norm(), 1e-12 * moments.norm());
  }
}

// The barrier of a logarithm: no number, which a solver rejects.
TYPED_TEST(Cells, TurnedInsideOutHaveNoEnergyWhereTheLawKnowsNone) {
  using E = TypeParam;
  const auto x = straight_cell<E>(7);
  const auto inside_out = this->affine(x, Matrix<3, 3>(Vector<3>(-1, 1, 1).asDiagonal()));
  EXPECT_TRUE(std::isnan(response_of<E>(x, inside_out, neo_hookean).energy));
  EXPECT_TRUE(std::isfinite(response_of<E>(x, inside_out, rubber).energy));
}

}  // namespace
}  // namespace ritz::fem
