// The stiffness against the energy of linear elasticity, its null space, constant strain and invariances.
#include "ritz/fem/cell_matrices.hpp"

#include "fem/sample_cells.hpp"
#include "ritz/fem/face.hpp"
#include "support/dense_algebra.hpp"

namespace ritz::fem::testing {
namespace {

constexpr ElasticConstants material = {1.5, .95};

Eigen::VectorXd flat(const Eigen::MatrixXd& u) { return Eigen::Map<const Eigen::VectorXd>(u.data(), u.size()); }

Eigen::MatrixXd stiffness_of(CellType type, const CellVectors& x, const ElasticConstants& constants = material) {
  return stiffness(type, x, constants);
}

struct Stiffness : ::testing::TestWithParam<CellType> {
  CellType type = GetParam();
};
INSTANTIATE_TEST_SUITE_P(, Stiffness, every_cell(), cell_name);

/// Σ w det J W(F), W = λ/2 tr(E)² + μ E:E, straight from F = (x + u) ∂N (x ∂N)⁻¹.
double energy(CellType type, const Eigen::MatrixXd& x, const Eigen::MatrixXd& u) {
  double sum = 0;
  const auto& rule = element(type).rule;
  for (int q = 0; q < rule.count(); ++q) {
    const double weight = rule.weights[static_cast<std::size_t>(q)];
    const Eigen::Map<const Eigen::MatrixXd> gradient(rule.gradients.data() + 3 * x.cols() * q, x.cols(), 3);
    const Matrix<3, 3> J = x * gradient, deformed = (x + u) * gradient, F = deformed * J.inverse();
    const Matrix<3, 3> strain = (F.transpose() * F - Matrix<3, 3>::Identity()) / 2;
    const double density = material.lambda / 2 * std::pow(strain.trace(), 2) + material.mu * strain.squaredNorm();
    sum += weight * J.determinant() * density;
  }
  return sum;
}

/// d²/dt² energy(t u) at 0: the energy is a quartic in t, so these differences are exact.
double second_derivative(CellType type, const Eigen::MatrixXd& x, const Eigen::MatrixXd& u) {
  const auto even = [&](double t) { return (energy(type, x, t * u) + energy(type, x, -t * u)) / 2; };
  return (16 * even(1) - even(2)) / 6;
}

TEST_P(Stiffness, IsTheHessianOfTheEnergy) {
  const auto cell = curved_cell(type, 1);
  const Eigen::MatrixXd x = cell, K = stiffness_of(type, cell);
  for (int i = 0; i < K.rows(); ++i)
    for (int j = i; j < K.cols(); ++j) {
      Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(3, x.cols()), difference = sum;
      sum(i) += .5;
      sum(j) += .5;
      difference(i) += .5;
      difference(j) -= .5;
      const double entry = second_derivative(type, x, sum) - second_derivative(type, x, difference);
      EXPECT_NEAR(K(i, j), entry, 1e-12 * K.norm()) << i << ' ' << j;
    }
}

TEST_P(Stiffness, IsExactlySymmetric) {
  const Eigen::MatrixXd K = stiffness_of(type, curved_cell(type, 2));
  EXPECT_EQ((K - K.transpose()).cwiseAbs().maxCoeff(), 0);
}

TEST_P(Stiffness, NullSpaceIsTheSixRigidMotionsAndNoMore) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto x = curved_cell(type, seed);
    const auto K = stiffness_of(type, x);
    const Eigen::VectorXd values = test::symmetric_eigenvalues(K);
    const double largest = values.maxCoeff();
    const int free = type == CellType::wedge6 ? 7 : 6;  // a wedge twists freely about its own axis
    EXPECT_LT(values.head(free).cwiseAbs().maxCoeff(), 1e-14 * largest);
    EXPECT_GT(values[free], 1e-4 * largest);
    for (int d = 0; d < 3; ++d) {
      const Vector<3> axis = Vector<3>::Unit(d);
      Eigen::MatrixXd translation(3, x.cols()), turn = x;
      for (int a = 0; a < x.cols(); ++a) {
        translation.col(a) = axis;
        turn.col(a) = axis.cross(Vector<3>(turn.col(a)));
      }
      EXPECT_LT((K * flat(translation)).norm(), 1e-13 * largest);
      EXPECT_LT((K * flat(turn)).norm(), 1e-13 * largest);
    }
  }
}

// The vertex forces of a constant stress are those of its tractions σ n on the faces, and the energy is V σ:ε/2.
TEST_P(Stiffness, ConstantStrainBalancesItsTractions) {
  const auto x = straight_cell(type, 3);
  const Matrix<3, 3> A = random_matrix<3, 3>(31), strain = (A + A.transpose()) / 2;
  const Matrix<3, 3> stress = material.lambda * strain.trace() * Matrix<3, 3>::Identity() + 2 * material.mu * strain;
  const Eigen::MatrixXd points = x;
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(3, x.cols());
  for (const auto& side : shape(type).faces) {
    const auto v = side.vertices();
    FaceVectors corner(3, static_cast<int>(v.size()));
    for (int a = 0; a < corner.cols(); ++a) corner.col(a) = x.col(v[static_cast<std::size_t>(a)]);
    const Eigen::MatrixXd tractions = stress * Eigen::MatrixXd(pressure_vectors(side.type, corner));
    for (int a = 0; a < corner.cols(); ++a) force.col(v[static_cast<std::size_t>(a)]) += tractions.col(a);
  }
  const Eigen::VectorXd moved = flat(A * points), internal = stiffness_of(type, x) * moved;
  EXPECT_LT((internal - flat(force)).norm(), 1e-13 * force.norm());
  const double V = integrate_finely(type, [&](const Point<3>& xi) { return jacobian(type, x, xi); });
  EXPECT_NEAR(moved.dot(internal), V * stress.cwiseProduct(strain).sum(), 1e-13 * moved.norm() * internal.norm());
}

TEST_P(Stiffness, TurnsWithTheCell) {
  const auto x = curved_cell(type, 4);
  const Matrix<3, 3> Q = rotation();
  const Eigen::MatrixXd K = stiffness_of(type, x), turned = stiffness_of(type, mapped(Q, x));
  for (int a = 0; a < x.cols(); ++a)
    for (int b = 0; b < x.cols(); ++b) {
      const Matrix<3, 3> expected = Q * K.block<3, 3>(3 * a, 3 * b) * Q.transpose();
      EXPECT_LT((turned.block<3, 3>(3 * a, 3 * b) - expected).norm(), 1e-14 * K.norm());
    }
}

TEST_P(Stiffness, LosesNothingFarFromTheOrigin) {
  const auto x = rounded(curved_cell(type, 6));
  EXPECT_EQ(stiffness_of(type, x), stiffness_of(type, far_away(x)));
}

TEST_P(Stiffness, ScalesWithLengthAndModulus) {
  const auto x = curved_cell(type, 7);
  const auto K = stiffness_of(type, x);
  EXPECT_EQ(stiffness_of(type, mapped(2 * Matrix<3, 3>::Identity(), x)), Eigen::MatrixXd(2 * K));
  EXPECT_EQ(stiffness_of(type, x, {4 * material.lambda, 4 * material.mu}), Eigen::MatrixXd(4 * K));
}

}  // namespace
}  // namespace ritz::fem::testing
