// The stiffness against the energy of linear elasticity, its null space, constant strain and invariances.
#include "ritz/fem/stiffness.hpp"

#include "fem/sample_cells.hpp"
#include "ritz/fem/face.hpp"
#include "support/dense_algebra.hpp"

namespace ritz::fem::testing {
namespace {

constexpr ElasticConstants material = {1.5, .95};

Eigen::VectorXd flat(const Eigen::MatrixXd& u) { return Eigen::Map<const Eigen::VectorXd>(u.data(), u.size()); }

template <class E>
Eigen::MatrixXd stiffness_of(const Coordinates<E>& x, const ElasticConstants& constants = material) {
  return any_size(stiffness<E>(x, constants));
}

template <class E>
struct Stiffness : ::testing::Test {};
TYPED_TEST_SUITE(Stiffness, Elements);

/// Σ w det J W(F), W = λ/2 tr(E)² + μ E:E, straight from F = (x + u) ∂N (x ∂N)⁻¹.
template <class E>
double energy(const Eigen::MatrixXd& x, const Eigen::MatrixXd& u) {
  double sum = 0;
  for (const auto& [xi, weight] : E::rule) {
    const Eigen::MatrixXd gradient = any_size(E::gradient(xi));
    const Matrix<3, 3> J = x * gradient, deformed = (x + u) * gradient, F = deformed * J.inverse();
    const Matrix<3, 3> strain = (F.transpose() * F - Matrix<3, 3>::Identity()) / 2;
    const double density = material.lambda / 2 * std::pow(strain.trace(), 2) + material.mu * strain.squaredNorm();
    sum += weight * J.determinant() * density;
  }
  return sum;
}

/// d²/dt² energy(t u) at 0: the energy is a quartic in t, so these differences are exact.
template <class E>
double second_derivative(const Eigen::MatrixXd& x, const Eigen::MatrixXd& u) {
  const auto even = [&](double t) { return (energy<E>(x, t * u) + energy<E>(x, -t * u)) / 2; };
  return (16 * even(1) - even(2)) / 6;
}

TYPED_TEST(Stiffness, IsTheHessianOfTheEnergy) {
  using E = TypeParam;
  const auto cell = curved_cell<E>(1);
  const Eigen::MatrixXd x = any_size(cell), K = stiffness_of<E>(cell);
  for (int i = 0; i < K.rows(); ++i)
    for (int j = i; j < K.cols(); ++j) {
      Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(3, E::vertices), difference = sum;
      sum(i) += .5;
      sum(j) += .5;
      difference(i) += .5;
      difference(j) -= .5;
      const double entry = second_derivative<E>(x, sum) - second_derivative<E>(x, difference);
      EXPECT_NEAR(K(i, j), entry, 1e-12 * K.norm()) << i << ' ' << j;
    }
}

TYPED_TEST(Stiffness, IsExactlySymmetric) {
  const Eigen::MatrixXd K = stiffness_of<TypeParam>(curved_cell<TypeParam>(2));
  EXPECT_EQ((K - K.transpose()).cwiseAbs().maxCoeff(), 0);
}

TYPED_TEST(Stiffness, NullSpaceIsTheSixRigidMotionsAndNoMore) {
  using E = TypeParam;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto x = curved_cell<E>(seed);
    const auto K = stiffness_of<E>(x);
    const Eigen::VectorXd values = test::symmetric_eigenvalues(K);
    const double largest = values.maxCoeff();
    EXPECT_LT(values.head(6).cwiseAbs().maxCoeff(), 1e-14 * largest);
    EXPECT_GT(values[6], 1e-4 * largest);
    for (int d = 0; d < 3; ++d) {
      const Vector<3> axis = Vector<3>::Unit(d);
      Eigen::MatrixXd translation(3, E::vertices), turn = any_size(x);
      for (int a = 0; a < E::vertices; ++a) {
        translation.col(a) = axis;
        turn.col(a) = axis.cross(Vector<3>(turn.col(a)));
      }
      EXPECT_LT((K * flat(translation)).norm(), 1e-13 * largest);
      EXPECT_LT((K * flat(turn)).norm(), 1e-13 * largest);
    }
  }
}

// The vertex forces of a constant stress are those of its tractions σ n on the faces, and the energy is V σ:ε/2.
TYPED_TEST(Stiffness, ConstantStrainBalancesItsTractions) {
  using E = TypeParam;
  const auto x = straight_cell<E>(3);
  const Matrix<3, 3> A = random_matrix<3, 3>(31), strain = (A + A.transpose()) / 2;
  const Matrix<3, 3> stress = material.lambda * strain.trace() * Matrix<3, 3>::Identity() + 2 * material.mu * strain;
  const Eigen::MatrixXd points = any_size(x);
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(3, E::vertices);
  constexpr auto face_type = shape(E::type).face;
  for (int face = 0; face < shape(E::type).faces; ++face)
    visit(face_type, [&]<class F>(F) {
      if constexpr (F::type == face_type) {
        const auto v = face_vertices(E::type, face);
        Coordinates<F> corner;
        for (int a = 0; a < F::vertices; ++a) corner.col(a) = x.col(v[a]);
        const Eigen::MatrixXd tractions = stress * any_size(pressure_vectors<F>(corner));
        for (int a = 0; a < F::vertices; ++a) force.col(v[a]) += tractions.col(a);
      }
    });
  const Eigen::VectorXd moved = flat(A * points), internal = stiffness_of<E>(x) * moved;
  EXPECT_LT((internal - flat(force)).norm(), 1e-13 * force.norm());
  const double V = integrate_finely<E>([&](const Point<3>& xi) { return jacobian<E>(x, xi).determinant(); });
  EXPECT_NEAR(moved.dot(internal), V * stress.cwiseProduct(strain).sum(), 1e-13 * moved.norm() * internal.norm());
}

TYPED_TEST(Stiffness, TurnsWithTheCell) {
  using E = TypeParam;
  const auto x = curved_cell<E>(4);
  const Matrix<3, 3> Q = rotation();
  const Eigen::MatrixXd K = stiffness_of<E>(x), turned = stiffness_of<E>(mapped<E>(Q, x));
  for (int a = 0; a < E::vertices; ++a)
    for (int b = 0; b < E::vertices; ++b) {
      const Matrix<3, 3> expected = Q * K.block<3, 3>(3 * a, 3 * b) * Q.transpose();
      EXPECT_LT((turned.block<3, 3>(3 * a, 3 * b) - expected).norm(), 1e-14 * K.norm());
    }
}

TYPED_TEST(Stiffness, LosesNothingFarFromTheOrigin) {
  using E = TypeParam;
  const auto x = rounded<E>(curved_cell<E>(6));
  EXPECT_EQ(stiffness_of<E>(x), stiffness_of<E>(far_away<E>(x)));
}

TYPED_TEST(Stiffness, ScalesWithLengthAndModulus) {
  using E = TypeParam;
  const auto x = curved_cell<E>(7);
  const auto K = stiffness_of<E>(x);
  EXPECT_EQ(stiffness_of<E>(mapped<E>(2 * Matrix<3, 3>::Identity(), x)), Eigen::MatrixXd(2 * K));
  EXPECT_EQ(stiffness_of<E>(x, {4 * material.lambda, 4 * material.mu}), Eigen::MatrixXd(4 * K));
}

}  // namespace
}  // namespace ritz::fem::testing
