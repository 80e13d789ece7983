// The stiffness against the energy of linear elasticity, its null space, constant strain and invariances.
#include "ritz/fem/stiffness.hpp"

#include <Eigen/Eigenvalues>

#include "fem/sample_cells.hpp"
#include "ritz/fem/face.hpp"

namespace ritz::fem::testing {
namespace {

constexpr ElasticConstants material = {1.5, .95};

// Of no fixed size where the size does not matter: the compiler is done with a product once for all cells.
template <class E>
Eigen::VectorXd flat(const Coordinates<E>& u) {
  return Eigen::Map<const Eigen::VectorXd>(u.data(), u.size());
}

template <class E>
struct Stiffness : ::testing::Test {};
TYPED_TEST_SUITE(Stiffness, Elements);

/// Σ w det J W(F), W = λ/2 tr(E)² + μ E:E, straight from F = (x + u) ∂N (x ∂N)⁻¹.
template <class E>
double energy(const Coordinates<E>& x, const Coordinates<E>& u) {
  double sum = 0;
  for (const auto& [xi, weight] : E::rule) {
    const Matrix<3, 3> J = x * E::gradient(xi), F = (x + u) * E::gradient(xi) * J.inverse();
    const Matrix<3, 3> strain = (F.transpose() * F - Matrix<3, 3>::Identity()) / 2;
    const double density = material.lambda / 2 * std::pow(strain.trace(), 2) + material.mu * strain.squaredNorm();
    sum += weight * J.determinant() * density;
  }
  return sum;
}

/// d²/dt² energy(t u) at 0: the energy is a quartic in t, so these differences are exact.
template <class E>
double second_derivative(const Coordinates<E>& x, const Coordinates<E>& u) {
  const auto even = [&](double t) { return (energy<E>(x, t * u) + energy<E>(x, -t * u)) / 2; };
  return (16 * even(1) - even(2)) / 6;
}

TYPED_TEST(Stiffness, IsTheHessianOfTheEnergy) {
  using E = TypeParam;
  const auto x = curved_cell<E>(1);
  const Eigen::MatrixXd K = stiffness<E>(x, material);
  for (int i = 0; i < K.rows(); ++i)
    for (int j = i; j < K.cols(); ++j) {
      Coordinates<E> sum = Coordinates<E>::Zero(), difference = Coordinates<E>::Zero();
      sum(i) += .5;
      sum(j) += .5;
      difference(i) += .5;
      difference(j) -= .5;
      const double entry = second_derivative<E>(x, sum) - second_derivative<E>(x, difference);
      EXPECT_NEAR(K(i, j), entry, 1e-12 * K.norm()) << i << ' ' << j;
    }
}

TYPED_TEST(Stiffness, IsExactlySymmetric) {
  const Eigen::MatrixXd K = stiffness<TypeParam>(curved_cell<TypeParam>(2), material);
  EXPECT_EQ((K - K.transpose()).cwiseAbs().maxCoeff(), 0);
}

TYPED_TEST(Stiffness, NullSpaceIsTheSixRigidMotionsAndNoMore) {
  using E = TypeParam;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto x = curved_cell<E>(seed);
    const Eigen::MatrixXd K = stiffness<E>(x, material);
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
    const double largest = values.maxCoeff();
    EXPECT_LT(values.head(6).cwiseAbs().maxCoeff(), 1e-14 * largest);
    EXPECT_GT(values[6], 1e-4 * largest);
    for (int d = 0; d < 3; ++d) {
      const Vector<3> axis = Vector<3>::Unit(d);
      Coordinates<E> translation, turn;
      for (int a = 0; a < E::vertices; ++a) {
        translation.col(a) = axis;
        turn.col(a) = axis.cross(x.col(a));
      }
      EXPECT_LT((K * flat<E>(translation)).norm(), 1e-13 * largest);
      EXPECT_LT((K * flat<E>(turn)).norm(), 1e-13 * largest);
    }
  }
}

// The vertex forces of a constant stress are those of its tractions σ n on the faces, and the energy is V σ:ε/2.
TYPED_TEST(Stiffness, ConstantStrainBalancesItsTractions) {
  using E = TypeParam;
  const auto x = straight_cell<E>(3);
  const Matrix<3, 3> A = random_matrix<3, 3>(31), strain = (A + A.transpose()) / 2;
  const Matrix<3, 3> stress = material.lambda * strain.trace() * Matrix<3, 3>::Identity() + 2 * material.mu * strain;
  const Coordinates<E> u = A * x;
  Coordinates<E> force = Coordinates<E>::Zero();
  constexpr auto face_type = shape(E::type).face;
  for (int face = 0; face < shape(E::type).faces; ++face)
    visit(face_type, [&]<class F>(F) {
      if constexpr (F::type == face_type) {
        const auto v = face_vertices(E::type, face);
        Coordinates<F> corner;
        for (int a = 0; a < F::vertices; ++a) corner.col(a) = x.col(v[a]);
        const Coordinates<F> tractions = stress * pressure_vectors<F>(corner);
        for (int a = 0; a < F::vertices; ++a) force.col(v[a]) += tractions.col(a);
      }
    });
  const Eigen::MatrixXd K = stiffness<E>(x, material);
  const Eigen::VectorXd moved = flat<E>(u), internal = K * moved;
  EXPECT_LT((internal - flat<E>(force)).norm(), 1e-13 * force.norm());
  const double V = integrate_finely<E>([&](const Point<3>& xi) { return jacobian<E>(x, xi).determinant(); });
  EXPECT_NEAR(moved.dot(internal), V * stress.cwiseProduct(strain).sum(), 1e-13 * moved.norm() * internal.norm());
}

TYPED_TEST(Stiffness, TurnsWithTheCell) {
  using E = TypeParam;
  const auto x = curved_cell<E>(4);
  const Matrix<3, 3> Q = rotation();
  const Eigen::MatrixXd K = stiffness<E>(x, material), turned = stiffness<E>(Q * x, material);
  for (int a = 0; a < E::vertices; ++a)
    for (int b = 0; b < E::vertices; ++b) {
      const Matrix<3, 3> expected = Q * K.block<3, 3>(3 * a, 3 * b) * Q.transpose();
      EXPECT_LT((turned.block<3, 3>(3 * a, 3 * b) - expected).norm(), 1e-14 * K.norm());
    }
}

TYPED_TEST(Stiffness, LosesNothingFarFromTheOrigin) {
  using E = TypeParam;
  const auto x = rounded<E>(curved_cell<E>(6));
  const Coordinates<E> far = x.array() + 0x1p20;
  EXPECT_EQ(stiffness<E>(x, material), stiffness<E>(far, material));
}

TYPED_TEST(Stiffness, ScalesWithLengthAndModulus) {
  using E = TypeParam;
  const auto x = curved_cell<E>(7);
  EXPECT_EQ(stiffness<E>(2 * x, material), 2 * stiffness<E>(x, material));
  EXPECT_EQ(stiffness<E>(x, {4 * material.lambda, 4 * material.mu}), 4 * stiffness<E>(x, material));
}

}  // namespace
}  // namespace ritz::fem::testing
