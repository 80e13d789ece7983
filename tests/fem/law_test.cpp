// Each law against its own derivatives, its constants at rest, rotations, and responses that were computed elsewhere.
#include "ritz/fem/law.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "fem/sample_cells.hpp"
#include "ritz/fem/material.hpp"

namespace ritz::fem {
namespace {

using testing::random_matrix;

/// A law with its parameters, and what it answers in uniaxial stress at the stretch 1.5 (the lateral stretch, and P in
/// Pa) and in simple shear by .5 (P₁₂, Pa). New laws join here.
template <class L>
struct Example;

template <>
struct Example<StVK> {
  static constexpr StVK law = {1e6, .3};
  static constexpr double lateral = .79056941504209483, uniaxial = 9.375e5, shear = 276442.3076923077;
};

template <>
struct Example<NeoHookean> {
  static constexpr NeoHookean law = {1e6, .3};
  static constexpr double lateral = .880174591807, uniaxial = 3.7828017639e5, shear = 1.9230769231e5;
};

template <class L>
class Laws : public ::testing::Test {
 protected:
  static constexpr L law = Example<L>::law;

  static double energy(const Matrix<3, 3>& G) { return law.response(G).energy; }
  static Matrix<3, 3> stress(const Matrix<3, 3>& G) { return law.response(G).stress; }
  static Matrix<3, 3> some_gradient() { return .3 * random_matrix<3, 3>(7); }
};

using All = ::testing::Types<StVK, NeoHookean>;
TYPED_TEST_SUITE(Laws, All);

/// Row i + 3j is P_ij, column k + 3l is F_kl.
Matrix<9, 9> as_matrix(const Moduli& A) {
  Matrix<9, 9> matrix;
  for (int p = 0; p < 9; ++p)
    for (int q = 0; q < 9; ++q) matrix(p, q) = A(p % 3, p / 3, q % 3, q / 3);
  return matrix;
}

/// A central difference on two scales, extrapolated: its error is of the fourth order.
template <class F>
auto slope(const F& f, double h) {
  using Value = decltype(f(h));
  const auto once = [&](double step) { return Value((f(step) - f(-step)) / (2 * step)); };
  return Value((4 * once(h / 2) - once(h)) / 3);
}

TYPED_TEST(Laws, AnswerAsComputedElsewhere) {
  using Known = Example<TypeParam>;
  const auto P = this->stress(Vector<3>(.5, Known::lateral - 1, Known::lateral - 1).asDiagonal());
  EXPECT_NEAR(P(0, 0), Known::uniaxial, 1e-9 * Known::uniaxial);
  EXPECT_LE(std::abs(P(1, 1)) + std::abs(P(2, 2)), 1e-9 * Known::uniaxial);
  Matrix<3, 3> shear = Matrix<3, 3>::Zero();
  shear(0, 1) = .5;
  EXPECT_NEAR(this->stress(shear)(0, 1), Known::shear, 1e-9 * Known::shear);
}

TYPED_TEST(Laws, StressIsTheDerivativeOfTheEnergy) {
  const Matrix<3, 3> G = this->some_gradient();
  for (int k = 0; k < 9; ++k) {
    const Matrix<3, 3> d = Vector<9>::Unit(k).reshaped(3, 3);
    const double expected = slope([&](double t) { return this->energy(G + t * d); }, 1e-2);
    EXPECT_NEAR(this->stress(G)(k % 3, k / 3), expected, 1e-7 * this->stress(G).norm());
  }
}

TYPED_TEST(Laws, ModuliAreTheDerivativesOfTheStress) {
  const Matrix<3, 3> G = this->some_gradient();
  const Matrix<9, 9> A = as_matrix(this->law.moduli(G));
  EXPECT_LE((A - A.transpose()).norm(), 1e-15 * A.norm());
  for (int k = 0; k < 9; ++k) {
    const Matrix<3, 3> d = Vector<9>::Unit(k).reshaped(3, 3);
    const Matrix<3, 3> expected = slope([&](double t) -> Matrix<3, 3> { return this->stress(G + t * d); }, 1e-2);
    EXPECT_LE((A.col(k) - Eigen::Map<const Vector<9>>(expected.data())).norm(), 1e-7 * A.norm());
  }
}

TYPED_TEST(Laws, RotationsTurnTheStressAndCostNothing) {
  const Matrix<3, 3> G = this->some_gradient(), I = Matrix<3, 3>::Identity();
  for (const double angle : {.1, 1.0, 2.5, M_PI}) {
    const Matrix<3, 3> Q = Eigen::AngleAxisd(angle, Vector<3>(1, -2, .7).normalized()).toRotationMatrix();
    const Matrix<3, 3> turned = Q * (I + G) - I;
    EXPECT_NEAR(this->energy(turned), this->energy(G), 1e-13 * this->energy(G));
    EXPECT_LE((this->stress(turned) - Q * this->stress(G)).norm(), 1e-13 * this->stress(G).norm());
    EXPECT_LE(this->energy(Q - I), 1e-13 * this->energy(G));
  }
}

TYPED_TEST(Laws, RestIsHookesLaw) {
  const auto elastic = this->law.at_rest();
  EXPECT_EQ(this->energy(Matrix<3, 3>::Zero()), 0);
  EXPECT_EQ(this->stress(Matrix<3, 3>::Zero()).norm(), 0);
  const Matrix<3, 3> G = random_matrix<3, 3>(8), e = (G + G.transpose()) / 2;
  Matrix<3, 3> hooke = 2 * elastic.mu * e;
  hooke.diagonal().array() += elastic.lambda * e.trace();
  const Vector<9> P = as_matrix(this->law.moduli(Matrix<3, 3>::Zero())) * Eigen::Map<const Vector<9>>(G.data());
  EXPECT_LE((P - Eigen::Map<const Vector<9>>(hooke.data())).norm(), 1e-14 * hooke.norm());
  EXPECT_NEAR(elastic.young(), 1e6, 1e-8);
  EXPECT_NEAR(elastic.poisson(), .3, 1e-14);
}

// The energy of a strain E less its terms of second and third order is of fourth order: it falls by 16 as E is halved.
TYPED_TEST(Laws, ConstantsOfThirdOrderAreTheNextTerm) {
  const auto [lambda, mu, A, B, C] = this->law.at_rest();
  const Matrix<3, 3> symmetric = random_matrix<3, 3>(9) + random_matrix<3, 3>(9).transpose();
  const auto rest = [&, lambda = lambda, mu = mu, A = A, B = B, C = C](double size) {
    const Matrix<3, 3> G = size * symmetric, E = StVK::strain(G), square = E * E;
    const double tr = E.trace(), two = square.trace(), three = (square * E).trace();
    return this->energy(G) - (lambda / 2 * tr * tr + mu * two + A / 3 * three + B * tr * two + C / 3 * tr * tr * tr);
  };
  const double scale = mu * std::pow(symmetric.norm(), 4);
  for (double size = .02; size > .002; size /= 2) {
    if (std::abs(rest(size)) < 1e-12 * scale * size * size) continue;  // no more terms
    EXPECT_NEAR(rest(size) / rest(size / 2), 16, 2) << size;
  }
}

// As small as strains get: energy and stress keep their digits, and do not drown in those of 1.
TYPED_TEST(Laws, SmallStrainsKeepTheirDigits) {
  const auto elastic = this->law.at_rest();
  const Matrix<3, 3> e = random_matrix<3, 3>(10) + random_matrix<3, 3>(10).transpose();
  const double expected = elastic.lambda / 2 * std::pow(e.trace(), 2) + elastic.mu * e.squaredNorm();
  for (const double size : {1e-9, 1e-12, 1e-30}) {
    EXPECT_NEAR(this->energy(size * e) / (size * size), expected, 1e-7 * expected) << size;
    EXPECT_NEAR(this->stress(size * e).cwiseProduct(e).sum() / size, 2 * expected, 1e-7 * expected) << size;
  }
  for (const double size : {1e-9, 1e-12}) {  // beside a stretch twice as large, to rounding
    const double doubled = this->energy(2 * size * e) / (4 * size * size),
                 single = this->energy(size * e) / (size * size);
    EXPECT_NEAR(doubled, single, 100 * size * single + 1e-14 * single);
  }
}

TYPED_TEST(Laws, AreMadeByName) {
  const auto law =
      make_law(TypeParam::name, [](const Parameter& p) { return p.name == poisson_ratio.name ? .3 : 1e6; });
  ASSERT_TRUE(law);
  ASSERT_TRUE(std::holds_alternative<TypeParam>(*law));
  EXPECT_EQ(std::get<TypeParam>(*law).values(), this->law.values());
  const auto told = parameters(*law);
  ASSERT_EQ(told.size(), TypeParam::parameters.size());
  for (std::size_t i = 0; i < told.size(); ++i) {
    EXPECT_STREQ(told[i].parameter.name, TypeParam::parameters[i].name);
    EXPECT_EQ(told[i].value, this->law.values()[i]);
    EXPECT_TRUE(told[i].possible());
  }
  EXPECT_TRUE(std::ranges::count(law_names(), std::string_view(TypeParam::name)));
}

// As far as a user's mistake goes: the warning that names it states the number.
TEST(ElasticConstants, AreThoseGivenHoweverLarge) {
  for (const double young : {1e-200, 1., 1e200}) {
    const auto elastic = StVK{young, .3}.at_rest();
    EXPECT_NEAR(elastic.young() / young, 1, 1e-14);
    EXPECT_NEAR(elastic.poisson(), .3, 1e-14);
  }
}

TEST(MakeLaw, KnowsNoOthers) {
  EXPECT_FALSE(make_law("rubber", [](const Parameter&) { return 1.0; }));
}

TEST(NeoHookean, KnowsNoStateThatIsInsideOut) {
  const Matrix<3, 3> flat = Vector<3>(-1, 0, 0).asDiagonal(), inside_out = Vector<3>(-1.5, 0, 0).asDiagonal();
  for (const auto& G : {flat, inside_out}) {
    EXPECT_TRUE(std::isnan(Example<NeoHookean>::law.response(G).energy));
    EXPECT_TRUE(as_matrix(Example<NeoHookean>::law.moduli(G)).array().isNaN().all());
  }
}

// Of a body with one other law there is no polynomial, and code that is made for polynomials refuses the law's type.
TEST(ForceDegree, IsThatOfAPolynomialLaw) {
  const Material stvk{StVK{1e6, .3}, 1000}, neo_hookean{NeoHookean{1e6, .3}, 1000};
  EXPECT_EQ(force_degree({stvk, stvk}), 3);
  EXPECT_EQ(force_degree({stvk, neo_hookean}), std::nullopt);
  EXPECT_EQ(all_of<StVK>({stvk, stvk})->size(), 2u);
  EXPECT_FALSE(all_of<StVK>({stvk, neo_hookean}));
  static_assert(PolynomialLaw<StVK> && Law<NeoHookean> && !PolynomialLaw<NeoHookean>);
}

}  // namespace
}  // namespace ritz::fem
