#include "ritz/runtime/internal_force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ritz/base/error.hpp"
#include "ritz/runtime/polynomial_force.hpp"
#include "support/sample_polynomial.hpp"

namespace ritz::runtime {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Energy, force and tangent straight from the strains of the energy that the polynomial comes from.
struct Reference {
  double energy = 0;
  VectorXd force;
  MatrixXd tangent;
};

Reference reference(const test::StrainEnergy& e, const VectorXd& z) {
  Reference out{0, VectorXd::Zero(z.size()), MatrixXd::Zero(z.size(), z.size())};
  for (Eigen::Index m = 0; m < e.a.rows(); ++m) {
    const auto& Q = e.Q[static_cast<std::size_t>(m)];
    const double strain = e.strain(m, z);
    const VectorXd slope = e.a.row(m).transpose() + Q * z;
    out.energy += strain * strain / 2;
    out.force += strain * slope;
    out.tangent += slope * slope.transpose() + strain * Q;
  }
  return out;
}

const std::vector<Eigen::Index> sizes = {1, 2, 3, 4, 5, 6, 7, 8, 9, 13, 20, 30, 41, 60};

TEST(Forces, AreThoseOfTheStrains) {
  for (const auto r : sizes) {
    const auto strains = test::random_strains(r, 10);
    const auto forces = make_polynomial_force<double>(test::polynomial_of(strains));
    auto result = make_evaluation(forces);
    for (const double scale : {0.0, 1e-3, 1.0, 30.0}) {
      const VectorXd z = scale * VectorXd::LinSpaced(r, -1, 0.7);
      const auto expected = reference(strains, z);
      evaluate(forces, z, result);
      EXPECT_NEAR(result.energy, expected.energy, 1e-13 * expected.energy) << r;
      EXPECT_LE((result.force - expected.force).norm(), 1e-13 * expected.force.norm()) << r;
      EXPECT_LE((result.tangent - expected.tangent).norm(), 1e-13 * expected.tangent.norm()) << r;
      EXPECT_EQ(result.tangent, result.tangent.transpose().eval());
    }
  }
}

TEST(Forces, AreTheDerivativeOfTheEnergy) {
  const Eigen::Index r = 6;
  const auto forces = make_polynomial_force<double>(test::random_polynomial(r));
  auto here = make_evaluation(forces), there = make_evaluation(forces);
  const VectorXd z = VectorXd::LinSpaced(r, 0.4, -0.5);
  evaluate(forces, z, here);
  const double h = 1e-5;
  for (Eigen::Index i = 0; i < r; ++i) {
    VectorXd beside = z;
    beside[i] += h;
    evaluate(forces, beside, there);
    const double above = there.energy;
    const VectorXd force_above = there.force;
    beside[i] -= 2 * h;
    evaluate(forces, beside, there);
    EXPECT_NEAR((above - there.energy) / (2 * h), here.force[i], 1e-8 * here.force.norm());
    EXPECT_LE(((force_above - there.force) / (2 * h) - here.tangent.col(i)).norm(), 1e-8 * here.tangent.norm());
  }
}

TEST(Forces, InSinglePrecision) {
  for (const auto r : sizes) {
    const auto polynomial = test::random_polynomial(r);
    const auto wide = make_polynomial_force<double>(polynomial);
    const auto narrow = make_polynomial_force<float>(polynomial);
    auto expected = make_evaluation(wide);
    auto result = make_evaluation(narrow);
    const VectorXd z = VectorXd::LinSpaced(r, -1, 0.7);
    evaluate(wide, z, expected);
    evaluate(narrow, z.cast<float>(), result);
    EXPECT_NEAR(result.energy, expected.energy, 1e-5 * expected.energy) << r;
    EXPECT_LE((result.force.cast<double>() - expected.force).norm(), 1e-5 * expected.force.norm()) << r;
    EXPECT_LE((result.tangent.cast<double>() - expected.tangent).norm(), 1e-5 * expected.tangent.norm()) << r;
  }
}

template <class Scalar>
void expect_batch_is_single(double tolerance) {
  for (const auto r : sizes) {
    const auto forces = make_polynomial_force<Scalar>(test::random_polynomial(r));
    const Eigen::Index instances = 11;
    auto batch = make_batch_evaluation(forces, instances);
    auto single = make_evaluation(forces);
    const Matrix<Scalar> z = Matrix<Scalar>::Random(r, instances);
    evaluate_batch(forces, z, batch);
    for (Eigen::Index i = 0; i < instances; ++i) {
      evaluate(forces, z.col(i), single);
      EXPECT_NEAR(batch.energy[i], single.energy, tolerance * single.energy) << r;
      EXPECT_LE((batch.force.col(i) - single.force).norm(), tolerance * single.force.norm()) << r;
      EXPECT_LE((batch.tangents.middleCols(i * r, r) - single.tangent).norm(), tolerance * single.tangent.norm()) << r;
    }
  }
}

TEST(Forces, OfABatchAreThoseOfEach) {
  expect_batch_is_single<double>(1e-13);
  expect_batch_is_single<float>(1e-5);
}

TEST(Forces, MeanAlongAStepDoesTheWorkOfTheEnergy) {
  for (const auto r : sizes) {
    const auto forces = make_polynomial_force<double>(test::random_polynomial(r));
    auto mean = make_mean_evaluation(InternalForce<double>(forces));
    auto begin = make_evaluation(forces), end = begin;
    const VectorXd z = VectorXd::LinSpaced(r, -1, 0.7), d = VectorXd::LinSpaced(r, 2, 0.5);
    evaluate_mean<double>(InternalForce<double>(forces), z, d, mean);
    evaluate(forces, z, begin);
    evaluate(forces, z + d, end);
    EXPECT_NEAR(mean.force.dot(d), end.energy - begin.energy, 1e-13 * end.energy) << r;
  }
}

TEST(Forces, MeanHasItsDerivative) {
  const Eigen::Index r = 5;
  const auto forces = make_polynomial_force<double>(test::random_polynomial(r));
  auto here = make_mean_evaluation(InternalForce<double>(forces)), above = here, below = here;
  const VectorXd z = VectorXd::LinSpaced(r, -1, 0.7), d = VectorXd::LinSpaced(r, 1, 0.5);
  evaluate_mean<double>(InternalForce<double>(forces), z, d, here);
  for (Eigen::Index i = 0; i < r; ++i) {
    const VectorXd side = 1e-5 * VectorXd::Unit(r, i);
    evaluate_mean<double>(InternalForce<double>(forces), z, d + side, above);
    evaluate_mean<double>(InternalForce<double>(forces), z, d - side, below);
    EXPECT_LE(((above.force - below.force) / 2e-5 - here.tangent.col(i)).norm(), 1e-8 * here.tangent.norm());
  }
}

TEST(Forces, TellOfWhatIsNotFinite) {
  const auto forces = make_polynomial_force<double>(test::random_polynomial(6));
  auto result = make_evaluation(forces);
  VectorXd z = VectorXd::Ones(6);
  z[3] = std::numeric_limits<double>::quiet_NaN();
  evaluate(forces, z, result);
  EXPECT_FALSE(std::isfinite(result.energy));
  EXPECT_FALSE(result.force.allFinite());
  z[3] = 1;
  evaluate(forces, z, result);
  EXPECT_TRUE(result.tangent.allFinite());
}

TEST(Forces, OfAPolynomialThatIsNotWhole) {
  auto polynomial = test::random_polynomial(4);
  polynomial.cubic.conservativeResize(polynomial.cubic.size() - 1);
  EXPECT_THROW(make_polynomial_force<double>(polynomial), InputError);
  EXPECT_THROW(make_polynomial_force<float>(model::Polynomial{}), InputError);
}

TEST(Forces, TangentAtRestIsTheQuadraticPart) {
  const auto strains = test::random_strains(5, 10);
  const auto forces = make_polynomial_force<double>(test::polynomial_of(strains));
  EXPECT_LE((forces.linear - strains.a.transpose() * strains.a).norm(), 1e-13 * 100);
}

}  // namespace
}  // namespace ritz::runtime
