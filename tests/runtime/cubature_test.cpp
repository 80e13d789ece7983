#include "ritz/runtime/cubature_force.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ritz/base/error.hpp"
#include "ritz/runtime/statics.hpp"
#include "runtime/nonlinear_support.hpp"
#include "support/sample_cubature.hpp"

namespace ritz::runtime {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using model::Integrand;
using test::SampleWeights;

template <class Scalar = double>
CubatureForce<Scalar> force_of(const test::SampleCubature& sample) {
  return make_cubature_force<Scalar>(sample.cubature, sample.materials, &sample.polynomial);
}

template <class Scalar = double>
Model<Scalar> model_of(const test::SampleCubature& sample, const Damping& damping = {}) {
  return make_model<Scalar>(sample.cubature, sample.materials, &sample.polynomial, damping);
}

VectorXd some_pose(Index r, double size) { return size * VectorXd::LinSpaced(r, -1, .7).normalized(); }

Evaluation<double> evaluated(const CubatureForce<double>& force, const VectorXd& z) {
  auto result = make_evaluation(force);
  evaluate<double>(force, z, result);
  return result;
}

/// Point by point, from the laws alone.
Evaluation<double> reference(const test::SampleCubature& sample, const VectorXd& z) {
  const auto& c = sample.cubature;
  Evaluation<double> sum;
  sum.force = VectorXd::Zero(z.size());
  sum.tangent = MatrixXd::Zero(z.size(), z.size());
  for (std::size_t cell = 0; cell < c.cells.size(); ++cell)
    for (Index p = c.starts[cell]; p < c.starts[cell + 1]; ++p) {
      const auto gradients = c.gradients.middleRows(9 * p, 9);
      const std::array<fem::Matrix<3, 3>, 1> G = {(gradients * z).reshaped(3, 3)};
      std::array<fem::Response, 1> response;
      std::array<fem::Moduli, 1> moduli;
      const auto& material = sample.materials[static_cast<std::size_t>(c.regions[cell])].material;
      fem::respond(material, G, response);
      fem::linearise(material, G, moduli);
      const double v = c.weights[static_cast<Index>(cell)] * c.volumes[p];
      MatrixXd A(9, 9);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l) A(3 * j + i, 3 * l + k) = moduli[0](i, j, k, l);
      sum.energy += v * response[0].energy;
      sum.force += v * gradients.transpose() * response[0].stress.reshaped();
      sum.tangent += v * gradients.transpose() * A * gradients;
    }
  return sum;
}

void expect_same(const Evaluation<double>& a, const Evaluation<double>& b, double tolerance, const std::string& what) {
  EXPECT_NEAR(a.energy, b.energy, tolerance * std::abs(b.energy)) << what;
  EXPECT_LE((a.force - b.force).norm(), tolerance * b.force.norm()) << what;
  EXPECT_LE((a.tangent - b.tangent).norm(), tolerance * b.tangent.norm()) << what;
  EXPECT_EQ(a.tangent, a.tangent.transpose().eval()) << what;
}

TEST(Cubature, SumsTheLawsAtItsPoints) {
  for (const Index r : {1, 2, 5, 6, 7, 8, 13, 20, 30})
    for (const Index points : {1, 7, 8, 9, 30}) {
      const auto sample = test::sample_cubature(r, points, test::all_isotropic_laws(), Integrand::energy);
      for (const double size : {1e-3, 1.0, 3.0}) {
        const VectorXd z = some_pose(r, size);
        expect_same(evaluated(force_of(sample), z), reference(sample, z), 1e-12,
                    std::to_string(r) + " " + std::to_string(points));
      }
    }
}

TEST(Cubature, WithAllCellsOfWeightOneIsTheSameBeyondThePolynomial) {
  auto sample = test::sample_cubature(9, 20, test::all_isotropic_laws(), Integrand::energy, SampleWeights::one);
  const auto whole = force_of(sample);
  sample.cubature.integrand = Integrand::beyond_polynomial;
  for (const double size : {1e-3, 1.0, 3.0})
    expect_same(evaluated(force_of(sample), some_pose(9, size)), evaluated(whole, some_pose(9, size)), 1e-11, "");
}

TEST(Cubature, OfStVKIsItsPolynomial) {
  const auto sample =
      test::sample_cubature(8, 20, {{"body", {fem::StVK{1e3, .3}, 1}}}, Integrand::energy, SampleWeights::one);
  const auto polynomial = make_polynomial_force<double>(sample.polynomial);
  auto expected = make_evaluation(polynomial);
  for (const double size : {1e-3, 1.0, 5.0}) {
    evaluate<double>(polynomial, some_pose(8, size), expected);
    expect_same(evaluated(force_of(sample), some_pose(8, size)), expected, 1e-11, "");
  }
}

TEST(Cubature, BeyondThePolynomialHasItsStiffnessAtRestWhateverTheWeights) {
  const auto sample = test::sample_cubature(8, 20, test::all_isotropic_laws(), Integrand::beyond_polynomial);
  const MatrixXd expected = make_polynomial_force<double>(sample.polynomial).linear;
  EXPECT_LE((stiffness_at_rest(force_of(sample)) - expected).norm(), 1e-12 * expected.norm());
  const auto rest = evaluated(force_of(sample), VectorXd::Zero(8));
  EXPECT_EQ(rest.energy, 0);
  EXPECT_EQ(rest.force.norm(), 0);
}

TEST(Cubature, ForceAndTangentAreDerivatives) {
  for (const auto integrand : {Integrand::energy, Integrand::beyond_polynomial})
    for (const auto& law : test::all_isotropic_laws()) {
      const auto force = force_of(test::sample_cubature(5, 9, {law}, integrand));
      const VectorXd z = some_pose(5, 2), d = VectorXd::LinSpaced(5, .3, -.5);
      const double h = 1e-5;
      const auto here = evaluated(force, z), above = evaluated(force, z + h * d), below = evaluated(force, z - h * d);
      EXPECT_NEAR((above.energy - below.energy) / (2 * h), here.force.dot(d), 1e-7 * here.force.norm()) << law.region;
      EXPECT_LE(((above.force - below.force) / (2 * h) - here.tangent * d).norm(), 1e-7 * here.tangent.norm())
          << law.region;
    }
}

TEST(Cubature, InSinglePrecisionHasItsDigits) {
  for (const auto integrand : {Integrand::energy, Integrand::beyond_polynomial}) {
    const auto sample = test::sample_cubature(21, 30, test::all_isotropic_laws(), integrand);
    const VectorXd z = some_pose(21, 2);
    const auto force = force_of<float>(sample);
    auto result = make_evaluation(force);
    evaluate<float>(force, z.cast<float>(), result);
    const auto expected = evaluated(force_of(sample), z);
    EXPECT_NEAR(result.energy, expected.energy, 1e-5 * expected.energy);
    EXPECT_LE((result.force.cast<double>() - expected.force).norm(), 1e-5 * expected.force.norm());
    EXPECT_LE((result.tangent.cast<double>() - expected.tangent).norm(), 1e-5 * expected.tangent.norm());
  }
}

/// A point that one coordinate squeezes: F = I − z e₁e₁ᵀ.
test::SampleCubature squeezed() {
  test::SampleCubature sample;
  sample.materials = {{"rubber", {fem::NeoHookean{1e3, .3}, 1}}};
  sample.cubature = {.integrand = Integrand::energy,
                     .cells = {1},
                     .weights = VectorXd::Ones(1),
                     .regions = {0},
                     .starts = {0, 1},
                     .volumes = VectorXd::Ones(1),
                     .gradients = -VectorXd::Unit(9, 0),
                     .errors = {}};
  return sample;
}

TEST(Cubature, IsNotANumberWhereALawDoesNotAdmitTheState) {
  const auto force = force_of(squeezed());
  EXPECT_TRUE(std::isfinite(evaluated(force, VectorXd::Constant(1, .99)).energy));
  for (const double z : {1.0, 1.5}) {
    const auto result = evaluated(force, VectorXd::Constant(1, z));
    EXPECT_TRUE(std::isnan(result.energy));
    EXPECT_TRUE(result.force.array().isNaN().all());
  }
}

TEST(Cubature, StepsTowardsAnInversionAreShortenedNotLost) {
  for (const auto& method : test::implicit_methods()) {
    auto motion = test::start<double>(model_of(squeezed(), {.alpha = 40, .beta = 0, .ratio = {}}), method, .2,
                                      VectorXd::Zero(1), 2e3);
    for (int n = 0; n < 20; ++n) {
      const auto outcome = motion.step();
      ASSERT_EQ(outcome.status, Status::done) << method.name << ' ' << n;
      ASSERT_LT(motion.state.z()[0], 1) << method.name;
    }
    EXPECT_GT(motion.state.z()[0], .5) << method.name;
  }
}

TEST(Cubature, AvfKeepsTheEnergy) {
  for (const auto integrand : {Integrand::energy, Integrand::beyond_polynomial}) {
    const auto sample = test::sample_cubature(8, 20, {test::all_isotropic_laws()[0]}, integrand);
    auto motion = test::start<double>(model_of(sample), avf(), .05, some_pose(8, 2));
    const double before = motion.energy();
    for (int n = 0; n < 400; ++n) ASSERT_EQ(motion.step().status, Status::done);
    EXPECT_NEAR(motion.energy(), before, 1e-9 * before);
    EXPECT_GT(motion.state.velocity().norm(), 0);
  }
}

TEST(Cubature, StaticsFindTheBalance) {
  const auto sample = test::sample_cubature(8, 20, test::all_isotropic_laws(), Integrand::beyond_polynomial);
  const auto model = model_of(sample);
  const VectorXd goal = some_pose(8, 2), load = evaluated(force_of(sample), goal).force;
  auto workspace = make_static_workspace<double>(model);
  VectorXd z = VectorXd::Zero(8);
  const auto outcome = solve_static<double>(model, {VectorXd::Zero(8), load}, z, workspace);
  EXPECT_FALSE(outcome.failure);
  EXPECT_LE((evaluated(force_of(sample), z).force - load).norm(), 1e-9 * load.norm());
}

TEST(Cubature, StaticsBeforeAnInversionAreNoLimitPoint) {
  const auto model = model_of(squeezed());
  auto workspace = make_static_workspace<double>(model, {.halvings = 3});
  VectorXd z = VectorXd::Zero(1);
  const auto outcome = solve_static<double>(model, {VectorXd::Zero(1), VectorXd::Constant(1, 1e6)}, z, workspace);
  EXPECT_EQ(outcome.failure, NoRest::not_converged);
  EXPECT_LT(z[0], 1);
}

TEST(Cubature, OfOtherShapesIsRefused) {
  const auto good = test::sample_cubature(4, 6, test::all_isotropic_laws(), Integrand::beyond_polynomial);
  EXPECT_NO_THROW(force_of(good));
  EXPECT_THROW(make_cubature_force<double>(good.cubature, good.materials, nullptr), InputError);
  const auto refuses = [&](auto&& damage) {
    auto bad = good;
    damage(bad);
    EXPECT_THROW(force_of(bad), InputError);
  };
  refuses([](auto& s) { s.cubature = {}; });
  refuses([](auto& s) { s.cubature.weights[0] = 0; });
  refuses([](auto& s) { s.cubature.weights[0] = NAN; });
  refuses([](auto& s) { s.cubature.regions[0] = 8; });
  refuses([](auto& s) { s.cubature.regions[0] = -1; });
  refuses([](auto& s) { s.cubature.starts[1] = 9; });
  refuses([](auto& s) { s.cubature.gradients.conservativeResize(9, 4); });
  refuses([](auto& s) { s.polynomial.r = 3; });
  refuses([](auto& s) { s.materials[0].material.law = fem::StVK{1e3, .3}; });
}

}  // namespace
}  // namespace ritz::runtime
