// StVK cells against closed forms, finite differences and the stiffness at rest.
#include "ritz/fem/stvk.hpp"

#include <cmath>

#include "fem/sample_cells.hpp"
#include "ritz/fem/stiffness.hpp"

namespace ritz::fem {
namespace {

using namespace testing;

constexpr StVK rubber{1e5, .3, 1000};

template <class E>
class Stvk : public ::testing::Test {
 protected:
  /// The displacement x ↦ (F − I) x.
  static Coordinates<E> affine(const Coordinates<E>& x, const Matrix<3, 3>& F) {
    return (F - Matrix<3, 3>::Identity()) * x;
  }
  static Matrix<3, 3> stretched(double along, double across) { return Vector<3>(along, across, across).asDiagonal(); }

  /// P = F S over the cell, from the force's moments: ∫ P dV = Σ f_a X_aᵀ.
  static Matrix<3, 3> mean_stress(const Coordinates<E>& x, const Coordinates<E>& u, double volume) {
    return energy_and_force<E>(x, u, rubber).force * x.transpose() / volume;
  }
  static double rule_volume(const Coordinates<E>& x) {
    double sum = 0;
    for (const auto& sample : E::rule) sum += physical_gradients<E>(relative<E>(x), sample).weight;
    return sum;
  }
};

TYPED_TEST_SUITE(Stvk, Elements);

TYPED_TEST(Stvk, UniaxialStressIsTheClosedForm) {
  using E = TypeParam;
  const auto x = straight_cell<E>(1);
  const double volume = this->rule_volume(x);
  for (const auto& [stretch, stress] : {std::pair{1.1, 11550.0}, {1.6, 124800.0}, {2.0, 300000.0}}) {
    const double across = std::sqrt(1 - rubber.poisson * (stretch * stretch - 1));
    const auto P = this->mean_stress(x, this->affine(x, this->stretched(stretch, across)), volume);
    const Matrix<3, 3> expected = Vector<3>(stress, 0, 0).asDiagonal();
    EXPECT_LE((P - expected).norm(), 1e-12 * stress) << stretch;
  }
}

TYPED_TEST(Stvk, UniaxialStrainIsTheClosedForm) {
  using E = TypeParam;
  const auto x = straight_cell<E>(2);
  const double volume = this->rule_volume(x), modulus = rubber.lambda() + 2 * rubber.mu();
  for (const double stretch : {.75, 1 / std::sqrt(3.0), 1.3}) {
    const double expected = modulus / 2 * stretch * (stretch * stretch - 1);
    EXPECT_NEAR(this->mean_stress(x, this->affine(x, this->stretched(stretch, 1)), volume)(0, 0), expected,
                1e-12 * std::abs(expected));
  }
  EXPECT_NEAR(modulus / 2 * .75 * (.75 * .75 - 1), -22085.34, .005);
}

TYPED_TEST(Stvk, RotationsCostNothing) {
  using E = TypeParam;
  const auto x = curved_cell<E>(3);
  const double scale = rubber.young * std::pow(this->rule_volume(x), 2. / 3);
  for (const double angle : {.1, 1.0, 2.5, M_PI}) {
    const Matrix<3, 3> Q = Eigen::AngleAxisd(angle, Vector<3>(1, -2, .7).normalized()).toRotationMatrix();
    const auto response = energy_and_force<E>(x, this->affine(x, Q), rubber);
    EXPECT_LE(response.force.norm(), 1e-12 * scale) << angle;
    EXPECT_LE(std::abs(response.energy), 1e-12 * scale) << angle;
  }
}

TYPED_TEST(Stvk, TangentAtRestIsTheStiffness) {
  using E = TypeParam;
  const auto x = curved_cell<E>(4);
  const Eigen::MatrixXd K = stiffness<E>(x, rubber), at_rest = tangent<E>(x, Coordinates<E>::Zero(), rubber);
  EXPECT_LE((at_rest - K).norm(), 1e-14 * K.norm());
}

// Energy is quartic in u: central differences on two scales, extrapolated, are exact but for rounding.
TYPED_TEST(Stvk, ForceAndTangentAreTheDerivatives) {
  using E = TypeParam;
  const auto x = curved_cell<E>(5);
  const Coordinates<E> u = .2 * random_matrix<3, E::vertices>(50), d = random_matrix<3, E::vertices>(51);
  const auto at = [&](double t) { return energy_and_force<E>(x, u + t * d, rubber); };
  const auto extrapolated = [](auto difference) {
    using Value = decltype(difference(.1));
    return Value((4 * difference(.05) - difference(.1)) / 3);
  };
  const auto here = at(0);
  const double slope = extrapolated([&](double h) { return (at(h).energy - at(-h).energy) / (2 * h); });
  EXPECT_NEAR(here.force.cwiseProduct(d).sum(), slope, 1e-10 * std::abs(slope));
  const Coordinates<E> change =
      extrapolated([&](double h) -> Coordinates<E> { return (at(h).force - at(-h).force) / (2 * h); });
  const Eigen::MatrixXd K = tangent<E>(x, u, rubber);
  const Eigen::VectorXd product = K * Eigen::Map<const Eigen::VectorXd>(d.data(), d.size());
  EXPECT_LE((product - Eigen::Map<const Eigen::VectorXd>(change.data(), change.size())).norm(), 1e-10 * product.norm());
  EXPECT_EQ((K - K.transpose()).norm(), 0);
}

TYPED_TEST(Stvk, ForcesBalance) {
  using E = TypeParam;
  const auto x = curved_cell<E>(6);
  const Coordinates<E> u = .3 * random_matrix<3, E::vertices>(60);
  const auto f = energy_and_force<E>(x, u, rubber).force;
  const Coordinates<E> shape = x + u;
  EXPECT_LE(f.rowwise().sum().norm(), 1e-13 * f.norm());
  const Matrix<3, 3> moments = f * shape.transpose();
  EXPECT_LE((moments - moments.transpose()).norm(), 1e-13 * moments.norm());
}

}  // namespace
}  // namespace ritz::fem
