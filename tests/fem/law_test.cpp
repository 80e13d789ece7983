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

template <>
struct Example<IsochoricNeoHookean> {
  static constexpr IsochoricNeoHookean law = {1e6, .3};
  static constexpr double lateral = .884338245423, uniaxial = 3.3839716624e5, shear = .5 * 1e6 / 2.6;
};

template <>
struct Example<MooneyRivlin> {
  static constexpr MooneyRivlin law = {.15e6, .04e6, 2e-6};
  static constexpr double lateral = .872388128567, uniaxial = 3.2327948615e5, shear = 1.9e5;
};

template <>
struct Example<Yeoh> {
  static constexpr Yeoh law = {.15e6, -2e3, 1e2, 2e-6};
  static constexpr double lateral = .865020575268, uniaxial = 2.7474084851e5, shear = 1.4901875e5;
};

template <>
struct Example<ArrudaBoyce> {
  static constexpr ArrudaBoyce law = {.35e6, 2.5, 2e-6};
  static constexpr double lateral = .880535742824, uniaxial = 3.5260340545e5, shear = 1.9680727478e5;
};

template <>
struct Example<Ogden> {
  static constexpr Ogden law = {.63e6, 1.3, 1.2e3, 5, -1e4, -2, 2e-6};
  static constexpr double lateral = .895635532042, uniaxial = 4.8910567996e5, shear = 3.0347773035e5;
};

template <>
struct Example<Hencky> {
  static constexpr Hencky law = {1e6, .3};
  static constexpr double lateral = .885467493296, uniaxial = 2.7031007207e5,
                          shear = 184675.17823660062;  // 2μ asinh(γ/2)/√(1 + γ²/4)
};

template <>
struct Example<Corotational> {
  static constexpr Corotational law = {1e6, .3};
  static constexpr double lateral = .85, uniaxial = 5e5, shear = 206662.25954551355;
};

template <>
struct Example<OrthotropicStVK> {
  static inline const OrthotropicStVK law{1e6, 5e5, 2e5, .3, .25, .2, 3e5, 2e5, 1e5, 1., 0., 0., 0., 1., 0.};
  static constexpr double uniaxial = 9.375e5;
};

template <class L>
class Laws : public ::testing::Test {
 protected:
  static inline const L law = Example<L>::law;

  static double energy(const Matrix<3, 3>& G) { return law.response(G).energy; }
  static Matrix<3, 3> stress(const Matrix<3, 3>& G) { return law.response(G).stress; }
  static Matrix<3, 3> some_gradient() { return .3 * random_matrix<3, 3>(7); }
};

using All = ::testing::Types<StVK, NeoHookean, IsochoricNeoHookean, MooneyRivlin, Yeoh, ArrudaBoyce, Ogden, Hencky,
                             Corotational>;
TYPED_TEST_SUITE(Laws, All);

/// Row i + 3j is P_ij, column k + 3l is F_kl.
Matrix<9, 9> as_matrix(const Moduli& A) {
  Matrix<9, 9> matrix;
  for (int p = 0; p < 9; ++p)
    for (int q = 0; q < 9; ++q) matrix(p, q) = A(p % 3, p / 3, q % 3, q / 3);
  return matrix;
}

/// C : e of a symmetric strain e.
Matrix<3, 3> stress_of(const ElasticConstants& elastic, const Matrix<3, 3>& e) {
  const Vector<6> s = elastic.hooke() * Vector<6>(e(0, 0), e(1, 1), e(2, 2), 2 * e(0, 1), 2 * e(1, 2), 2 * e(2, 0));
  Matrix<3, 3> S;
  S << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return S;
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
  if constexpr (requires { Known::lateral; }) {
    const auto P = this->stress(Vector<3>(.5, Known::lateral - 1, Known::lateral - 1).asDiagonal());
    EXPECT_NEAR(P(0, 0), Known::uniaxial, 1e-9 * Known::uniaxial);
    EXPECT_LE(std::abs(P(1, 1)) + std::abs(P(2, 2)), 1e-9 * Known::uniaxial);
    Matrix<3, 3> shear = Matrix<3, 3>::Zero();
    shear(0, 1) = .5;
    EXPECT_NEAR(this->stress(shear)(0, 1), Known::shear, 1e-9 * Known::shear);
  }
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
  const Matrix<3, 3> hooke = stress_of(elastic, e);
  const Vector<9> P = as_matrix(this->law.moduli(Matrix<3, 3>::Zero())) * Eigen::Map<const Vector<9>>(G.data());
  EXPECT_LE((P - Eigen::Map<const Vector<9>>(hooke.data())).norm(), 1e-14 * hooke.norm());
  if constexpr (!LawOfConstants<TypeParam>) {
    EXPECT_NEAR(elastic.young(), this->law.young, 1e-8);
    EXPECT_NEAR(elastic.poisson(), this->law.poisson, 1e-14);
  }
}

// The energy of a strain E less its terms of second and third order is of fourth order: it falls by 16 as E is halved.
TYPED_TEST(Laws, ConstantsOfThirdOrderAreTheNextTerm) {
  const auto elastic = this->law.at_rest();
  const Matrix<3, 3> symmetric = random_matrix<3, 3>(9) + random_matrix<3, 3>(9).transpose();
  const auto rest = [&](double size) {
    const Matrix<3, 3> G = size * symmetric, E = StVK::strain(G), square = E * E;
    const double tr = E.trace(), two = square.trace(), three = (square * E).trace();
    return this->energy(G) - (stress_of(elastic, E).cwiseProduct(E).sum() / 2 + elastic.A / 3 * three +
                              elastic.B * tr * two + elastic.C / 3 * tr * tr * tr);
  };
  const double scale = elastic.stiffest() * std::pow(symmetric.norm(), 4);
  for (double size = .02; size > .002; size /= 2) {
    if (std::abs(rest(size)) < 1e-12 * scale * size * size) continue;  // no more terms
    EXPECT_NEAR(rest(size) / rest(size / 2), 16, 2) << size;
  }
}

// As small as strains get: energy and stress keep their digits, and do not drown in those of 1.
TYPED_TEST(Laws, SmallStrainsKeepTheirDigits) {
  const auto elastic = this->law.at_rest();
  const Matrix<3, 3> e = random_matrix<3, 3>(10) + random_matrix<3, 3>(10).transpose();
  const double expected = stress_of(elastic, e).cwiseProduct(e).sum() / 2;
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
  const auto law = make_law(TypeParam::name, [&](const Parameter& p) {
    std::size_t i = 0;
    while (std::string_view(TypeParam::parameters[i].name) != p.name) ++i;
    return this->law.values()[i];
  });
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

// In uniaxial stress along the first axis: S₁₁ = E₁ e₁₁, e₂₂ = −ν₁₂ e₁₁, e₃₃ = −ν₁₃ e₁₁.
TEST(OrthotropicStVK, AnswersAlongItsAxes) {
  const auto& law = Example<OrthotropicStVK>::law;
  const Matrix<3, 3> G = Vector<3>(.5, .79056941504209483 - 1, .82915619758884995 - 1).asDiagonal();
  const auto P = law.response(G).stress;
  EXPECT_NEAR(P(0, 0), 9.375e5, 1e-4);
  EXPECT_LE(std::abs(P(1, 1)) + std::abs(P(2, 2)), 1e-4);
  // 2E₁₂ G₁₂ and so on, in the order 12, 13, 23.
  Matrix<3, 3> shear = Matrix<3, 3>::Zero();
  for (const auto& [i, j, modulus] : {std::tuple{0, 1, 3e5}, {0, 2, 2e5}, {1, 2, 1e5}}) {
    shear.setZero();
    shear(i, j) = 1e-9;
    EXPECT_NEAR(law.response(shear).stress(i, j), 1e-9 * modulus, 1e-9 * modulus * 1e-8);
  }
}

// A law with turned axes answers to a turned strain as the other answers to the strain.
TEST(OrthotropicStVK, TurnsWithItsAxes) {
  const auto& law = Example<OrthotropicStVK>::law;
  const Matrix<3, 3> Q = Eigen::AngleAxisd(1.1, Vector<3>(1, -2, .7).normalized()).toRotationMatrix();
  auto values = law.values();
  Eigen::Map<Vector<3>>(values.data() + 9) = 3 * Q.col(0);
  Eigen::Map<Vector<3>>(values.data() + 12) = Q.col(1) + .5 * Q.col(0);
  const OrthotropicStVK turned(values);
  const Matrix<3, 3> G = .3 * random_matrix<3, 3>(7);
  const Matrix<3, 3> expected = Q * law.response(G).stress * Q.transpose();
  EXPECT_LE((turned.response(Q * G * Q.transpose()).stress - expected).norm(), 1e-14 * expected.norm());
  EXPECT_NEAR(turned.at_rest().young(), law.at_rest().young(), 1e-8);
  EXPECT_NEAR(turned.angle_of_axes(), 2 / std::sqrt(5), 1e-14);
}

// With constants that are isotropic it is StVK.
TEST(OrthotropicStVK, MayBeIsotropic) {
  const OrthotropicStVK law(1e6, 1e6, 1e6, .3, .3, .3, 1e6 / 2.6, 1e6 / 2.6, 1e6 / 2.6, 1., 2., 3., -1., 0., 1.);
  const Matrix<3, 3> G = .3 * random_matrix<3, 3>(7);
  const StVK same{1e6, .3};
  EXPECT_LE((law.response(G).stress - same.response(G).stress).norm(), 1e-14 * same.response(G).stress.norm());
  EXPECT_NEAR(law.at_rest().young(), 1e6, 1e-8);
  EXPECT_NEAR(law.at_rest().poisson(), .3, 1e-14);
  EXPECT_NEAR(law.at_rest().stiffest(), same.at_rest().stiffest(), 1e-8);
}

// A law in MPa is the law in Pa; numbers without units stay.
TYPED_TEST(Laws, KnowTheUnitsOfTheirParameters) {
  const AnyLaw in_pascals = to_si(this->law, 1e6);
  const Matrix<3, 3> G = .1 * random_matrix<3, 3>(7);
  const auto stress = std::visit([&](const auto& law) { return law.response(G).stress; }, in_pascals);
  EXPECT_LE((stress - 1e6 * this->stress(G)).norm(), 1e-14 * stress.norm());
}

// Constants that each are possible, but not together.
TEST(UnstableAtRest, NamesTheModulusThatIsNotPositive) {
  EXPECT_FALSE(unstable_at_rest(StVK{1e6, .3}));
  EXPECT_FALSE(unstable_at_rest(Example<MooneyRivlin>::law));
  EXPECT_FALSE(unstable_at_rest(Example<OrthotropicStVK>::law));
  EXPECT_EQ(unstable_at_rest(MooneyRivlin{1e5, -2e5, 1e-6})->value, -2e5);  // 2 (C10 + C01)
  EXPECT_LT(unstable_at_rest(OrthotropicStVK(1e6, 1e6, 1e6, .9, .9, .9, 1e5, 1e5, 1e5, 1., 0., 0., 0., 1., 0.))->value,
            0);
  EXPECT_EQ(unstable_at_rest(OrthotropicStVK(1e6, 1e6, 1e6, .3, .3, .3, 1e5, 1e5, 1e5, 1., 2., 0., 2., 4., 0.))->value,
            0);
  EXPECT_EQ(unstable_at_rest(Ogden{.mu1 = 1e5, .alpha1 = 0, .d1 = 1e-6})->value, 0);
}

TEST(MakeLaw, KnowsNoOthers) {
  EXPECT_FALSE(make_law("rubber", [](const Parameter&) { return 1.0; }));
}

TYPED_TEST(Laws, AdmitNoStateThatIsInsideOutOrAreDefinedThere) {
  const Matrix<3, 3> flat = Vector<3>(-1, 0, 0).asDiagonal(), inside_out = Vector<3>(-1.5, 0, 0).asDiagonal();
  for (const auto& G : {flat, inside_out}) {
    const auto A = as_matrix(this->law.moduli(G));
    if constexpr (PolynomialLaw<TypeParam>) {
      EXPECT_TRUE(std::isfinite(this->energy(G)) && A.allFinite());
    } else {
      EXPECT_TRUE(std::isnan(this->energy(G)) && this->stress(G).array().isNaN().all() && A.array().isNaN().all());
    }
  }
}

// As two or three principal stretches meet, the moduli go to those of the stretches that coincide.
TYPED_TEST(Laws, StretchesMayCoincide) {
  const Matrix<3, 3> Q = Eigen::AngleAxisd(.8, Vector<3>(1, 2, -.5).normalized()).toRotationMatrix();
  for (const auto& limit : {Vector<3>(.2, .2, -.1), Vector<3>(.3, .3, .3), Vector<3>(0, 0, 0)}) {
    const auto moduli_at = [&](const Vector<3>& less_one) {
      return as_matrix(this->law.moduli(Q * less_one.asDiagonal() * Q.transpose()));
    };
    const Matrix<9, 9> A = moduli_at(limit);
    for (const double apart : {1e-3, 1e-5, 1e-7, 1e-9, 1e-12, 1e-15}) {
      const Matrix<9, 9> near = moduli_at(limit + apart * Vector<3>(1, -.5, .2));
      EXPECT_LE((near - A).norm(), (30 * apart + 1e-13) * A.norm()) << limit.transpose() << ", " << apart;
    }
  }
}

// Constants as a user lists them; a wrong number of them makes no law.
TYPED_TEST(Laws, AreMadeOfListedConstants) {
  if constexpr (LawOfConstants<TypeParam>) {
    const auto values = this->law.values();
    std::vector<double> given(values.begin(), values.end());
    if constexpr (std::is_same_v<TypeParam, OrthotropicStVK>) given.resize(9);  // without the axes
    else
      while (!given.empty() && given.back() == 0) given.pop_back();  // without further terms of the volume
    const auto law = TypeParam::of_constants(given);
    ASSERT_TRUE(law);
    EXPECT_EQ(law->values(), values);
    given.push_back(1);
    EXPECT_FALSE(TypeParam::of_constants(given));
    EXPECT_FALSE(TypeParam::of_constants({}));
  }
}

// Of a body with one other law there is no polynomial, and code that is made for polynomials refuses the law's type.
TEST(ForceDegree, IsThatOfAPolynomialLaw) {
  const Material stvk{StVK{1e6, .3}, 1000}, neo_hookean{NeoHookean{1e6, .3}, 1000};
  EXPECT_EQ(force_degree({stvk, stvk}), 3);
  EXPECT_EQ(force_degree({stvk, neo_hookean}), std::nullopt);
  static_assert(PolynomialLaw<StVK> && Law<NeoHookean> && !PolynomialLaw<NeoHookean>);
}

}  // namespace
}  // namespace ritz::fem
