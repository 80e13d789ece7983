// Cells of each element and law against closed forms, finite differences and the stiffness at rest. The forms of
// single laws are law_test's.
#include "ritz/fem/response.hpp"

#include <cmath>

#include "fem/sample_cells.hpp"
#include "ritz/fem/cell_matrices.hpp"

namespace ritz::fem {
namespace {

using namespace testing;

constexpr StVK stvk{1e5, .3};
const Material rubber{stvk, 1000}, neo_hookean{NeoHookean{1e5, .3}, 1000};

EnergyAndForce response_of(CellType type, const CellVectors& x, const CellVectors& u, const Material& material) {
  return energy_and_force(IntegrationPoints(type, x), u, material);
}
Eigen::MatrixXd tangent_of(CellType type, const CellVectors& x, const CellVectors& u, const Material& material) {
  return tangent(IntegrationPoints(type, x), u, material);
}

class Cells : public ::testing::TestWithParam<CellType> {
 protected:
  CellType type = GetParam();

  /// The displacement x ↦ (F − I) x.
  static CellVectors affine(const CellVectors& x, const Matrix<3, 3>& F) {
    return mapped(F - Matrix<3, 3>::Identity(), x);
  }
  static Matrix<3, 3> stretched(double along, double across) { return Vector<3>(along, across, across).asDiagonal(); }

  /// P = F S over the cell, from the force's moments: ∫ P dV = Σ f_a X_aᵀ.
  Matrix<3, 3> mean_stress(const CellVectors& x, const CellVectors& u, double volume) const {
    return Eigen::MatrixXd(response_of(type, x, u, rubber).force) * Eigen::MatrixXd(x).transpose() / volume;
  }
  double rule_volume(const CellVectors& x) const {
    const IntegrationPoints points(type, x);
    double sum = 0;
    for (int q = 0; q < points.count(); ++q) sum += points.weight(q);
    return sum;
  }
};
INSTANTIATE_TEST_SUITE_P(, Cells, every_cell(), cell_name);

TEST_P(Cells, UniaxialStressIsTheClosedForm) {
  const auto x = straight_cell(type, 1);
  const double volume = rule_volume(x);
  for (const auto& [stretch, stress] : {std::pair{1.1, 11550.0}, {1.6, 124800.0}, {2.0, 300000.0}}) {
    const double across = std::sqrt(1 - stvk.poisson * (stretch * stretch - 1));
    const auto P = mean_stress(x, affine(x, stretched(stretch, across)), volume);
    const Matrix<3, 3> expected = Vector<3>(stress, 0, 0).asDiagonal();
    EXPECT_LE((P - expected).norm(), 1e-12 * stress) << stretch;
  }
}

TEST_P(Cells, UniaxialStrainIsTheClosedForm) {
  const auto x = straight_cell(type, 2);
  const double volume = rule_volume(x), modulus = stvk.lambda() + 2 * stvk.mu();
  for (const double stretch : {.75, 1 / std::sqrt(3.0), 1.3}) {
    const double expected = modulus / 2 * stretch * (stretch * stretch - 1);
    EXPECT_NEAR(mean_stress(x, affine(x, stretched(stretch, 1)), volume)(0, 0), expected, 1e-12 * std::abs(expected));
  }
  EXPECT_NEAR(modulus / 2 * .75 * (.75 * .75 - 1), -22085.34, .005);
}

TEST_P(Cells, RotationsCostNothing) {
  const auto x = curved_cell(type, 3);
  const double scale = stvk.young * std::pow(rule_volume(x), 2. / 3);
  for (const double angle : {.1, 1.0, 2.5, M_PI}) {
    const Matrix<3, 3> Q = Eigen::AngleAxisd(angle, Vector<3>(1, -2, .7).normalized()).toRotationMatrix();
    for (const auto& material : {rubber, neo_hookean}) {
      const auto response = response_of(type, x, affine(x, Q), material);
      EXPECT_LE(Eigen::MatrixXd(response.force).norm(), 1e-12 * scale) << angle;
      EXPECT_LE(std::abs(response.energy), 1e-12 * scale) << angle;
    }
  }
}

TEST_P(Cells, TangentAtRestIsTheStiffness) {
  const auto x = curved_cell(type, 4);
  const Eigen::MatrixXd K = Eigen::MatrixXd(stiffness(type, x, rubber.at_rest()));
  for (const auto& material : {rubber, neo_hookean}) {
    const auto at_rest = tangent_of(type, x, CellVectors::Zero(3, x.cols()), material);
    EXPECT_LE((at_rest - K).norm(), 1e-14 * K.norm());
  }
}

// Central differences on two scales, extrapolated: exact but for rounding where the energy is quartic.
TEST_P(Cells, ForceAndTangentAreTheDerivatives) {
  const auto x = curved_cell(type, 5);
  for (const auto& [material, size, error] : {std::tuple{rubber, .2, 1e-10}, {neo_hookean, .02, 1e-6}}) {
    const Eigen::MatrixXd u = size * random_numbers(3, x.cols(), 50), d = size * random_numbers(3, x.cols(), 51);
    const auto at = [&, &law = material](double t) {
      const auto response = response_of(type, x, CellVectors(u + t * d), law);
      return std::pair{response.energy, Eigen::MatrixXd(response.force)};
    };
    const auto energy = [&](double h) { return (at(h).first - at(-h).first) / (2 * h); };
    const auto force = [&](double h) -> Eigen::MatrixXd { return (at(h).second - at(-h).second) / (2 * h); };
    const double slope = (4 * energy(.05) - energy(.1)) / 3;
    EXPECT_NEAR(at(0).second.cwiseProduct(d).sum(), slope, error * std::abs(slope)) << name(material.law);
    const Eigen::MatrixXd change = (4 * force(.05) - force(.1)) / 3;
    const auto K = tangent_of(type, x, CellVectors(u), material);
    const Eigen::VectorXd product = K * Eigen::Map<const Eigen::VectorXd>(d.data(), d.size());
    EXPECT_LE((product - Eigen::Map<const Eigen::VectorXd>(change.data(), change.size())).norm(),
              error * product.norm())
        << name(material.law);
    EXPECT_EQ((K - K.transpose()).norm(), 0);
  }
}

TEST_P(Cells, TangentsOfSeveralStatesAreSummedByTheirWeights) {
  const auto x = curved_cell(type, 8);
  const CellVectors u = .1 * random_numbers(3, x.cols(), 80), v = .1 * random_numbers(3, x.cols(), 81);
  const IntegrationPoints points(type, x);
  TangentSum sum(points);
  sum.add(u, rubber, .3);
  sum.add(v, neo_hookean, -2);
  const Eigen::MatrixXd expected = .3 * tangent_of(type, x, u, rubber) - 2 * tangent_of(type, x, v, neo_hookean);
  EXPECT_LE((Eigen::MatrixXd(sum.matrix()) - expected).norm(), 1e-14 * expected.norm());
}

TEST_P(Cells, ForcesBalance) {
  const auto x = curved_cell(type, 6);
  for (const auto& [material, size] : {std::pair{rubber, .3}, {neo_hookean, .03}}) {
    const Eigen::MatrixXd u = size * random_numbers(3, x.cols(), 60), shape = Eigen::MatrixXd(x) + u;
    const auto f = Eigen::MatrixXd(response_of(type, x, CellVectors(u), material).force);
    EXPECT_LE(f.rowwise().sum().norm(), 1e-12 * f.norm());
    const Matrix<3, 3> moments = f * shape.transpose();
    EXPECT_LE((moments - moments.transpose()).norm(), 1e-12 * moments.norm());
  }
}

// The barrier of a logarithm: no number, which a solver rejects.
TEST_P(Cells, TurnedInsideOutHaveNoEnergyWhereTheLawKnowsNone) {
  const auto x = straight_cell(type, 7);
  const auto inside_out = affine(x, Matrix<3, 3>(Vector<3>(-1, 1, 1).asDiagonal()));
  EXPECT_TRUE(std::isnan(response_of(type, x, inside_out, neo_hookean).energy));
  EXPECT_TRUE(std::isfinite(response_of(type, x, inside_out, rubber).energy));
}

}  // namespace
}  // namespace ritz::fem
