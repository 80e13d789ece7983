#include "ritz/fem/laws/isochoric.hpp"

#include <Eigen/LU>
#include <cmath>

#include "volume.hpp"

namespace ritz::fem {
namespace {

/// The energy f of a change of shape and its derivatives by Ī₁ and Ī₂, Pa; no law here is curved in Ī₂.
struct Shape {
  double energy, d1, d2 = 0, d11 = 0;
};

/// A state, from which all that depends on it follows. E' is the deviator of the Green-Lagrange strain E, so that with
/// a = 1 + 2/3 tr E (= tr C/3) and x = 2 |E'|²/a² − 8 det E'/a³ the volume is J² = a³ (1 − x). Hence Ī₁ = 3
/// (1−x)^(−1/3) and Ī₂ = (3 − 2 |E'|²/a²) (1−x)^(−2/3), in which small strains keep their digits.
struct State {
  double change, J;       ///< J − 1 and J
  Matrix<3, 3> strain;    ///< E'
  double a, square;       ///< tr C/3, |E'|²
  double first, second;   ///< Ī₁ − 3, Ī₂ − 3
  double scale1, scale2;  ///< J^(−2/3), J^(−4/3)
  bool admitted;

  explicit State(const Matrix<3, 3>& G) : change(G.trace() + nonlinear_volume_change(G)), J(1 + change) {
    admitted = change > -1;
    strain = (G + G.transpose() + G.transpose() * G) / 2;
    const double third = strain.trace() / 3;
    strain.diagonal().array() -= third;
    a = 1 + 2 * third;
    square = strain.squaredNorm();
    const double log = std::log1p(-(2 * square / a - 8 * strain.determinant() / (a * a)) / a);
    const double both = std::exp(-2. / 3 * log);
    first = 3 * std::expm1(-log / 3);
    second = 3 * std::expm1(-2. / 3 * log) - 2 * square / (a * a) * both;
    const double volume = std::log1p(change);
    scale1 = std::exp(-2. / 3 * volume);
    scale2 = scale1 * scale1;
  }

  /// dev(2 a E' − 4 E'²), of which ∂Ī₂/∂F is made.
  Matrix<3, 3> of_second() const {
    Matrix<3, 3> result = 2 * a * strain - 4 * strain * strain;
    result.diagonal().array() += 4. / 3 * square;
    return result;
  }
};

Matrix<3, 3> inverse_transpose(const Matrix<3, 3>& G) { return (Matrix<3, 3>::Identity() + G).inverse().transpose(); }

/// P = F⁻ᵀ (4 f₁ J^(−2/3) E' + 2 f₂ J^(−4/3) dev(2aE' − 4E'²) + J U' I).
Response response_of(const Matrix<3, 3>& G, const State& state, const Shape& f, const Volume& U) {
  Matrix<3, 3> inner = 4 * f.d1 * state.scale1 * state.strain;
  if (f.d2 != 0) inner += 2 * f.d2 * state.scale2 * state.of_second();
  inner.diagonal().array() += state.J * U.first;
  return {f.energy + U.energy, inverse_transpose(G) * inner};
}

/// The second derivative of W by F. With H = F⁻ᵀ, B = FFᵀ and I₁, I₂ the invariants of C:
///   Ī₁'' = J^(−2/3) (2 δ_ik δ_jl − 4/3 (F_ij H_kl + H_ij F_kl) + 4/9 I₁ H_ij H_kl + 2/3 I₁ H_il H_kj),
///   Ī₂'' = J^(−4/3) (I₂'' − 4/3 (I₂'_ij H_kl + H_ij I₂'_kl) + 16/9 I₂ H_ij H_kl + 4/3 I₂ H_il H_kj),
///   I₂' = 2 (I₁ F − FC), I₂'' = 4 F_ij F_kl + 2 (I₁ δ_ik δ_jl − δ_ik C_jl − F_il F_kj − B_ik δ_jl).
Moduli moduli_of(const Matrix<3, 3>& G, const State& state, const Shape& f, const Volume& U) {
  const Matrix<3, 3> I = Matrix<3, 3>::Identity(), F = I + G, H = inverse_transpose(G);
  const double one = 3 * state.a, two = 3 * state.a * state.a - 2 * state.square;
  const double f1 = f.d1 * state.scale1, f2 = f.d2 * state.scale2, J = state.J;
  Moduli A = Moduli::of_products(H, 4. / 9 * f1 * one + 16. / 9 * f2 * two + J * (J * U.second + U.first),
                                 2. / 3 * f1 * one + 4. / 3 * f2 * two - J * U.first);
  Matrix<3, 3> left = 2 * f1 * I, mixed = f1 * F;
  const Matrix<3, 3> g1 = 4 * state.scale1 * H * state.strain;
  if (f.d2 != 0) {
    const Matrix<3, 3> C = F.transpose() * F;
    left += 2 * f2 * (one * I - F * F.transpose());
    mixed += 2 * f2 * (one * F - F * C);
    A.add_product(-2 * f2 * I, C);
    A.add_products(F, 4 * f2, -2 * f2);
  }
  A.add_product(left, I);
  A.add_dyads(mixed, H, -4. / 3);
  if (f.d11 != 0) A.add_products(g1, f.d11, 0);
  return A;
}

/// From Ī₁ − 3 = 2 t₂ − 2/3 t₁² − 8/3 t₃ + 8/27 t₁³ + …, Ī₂ − 3 = 2 t₂ − 2/3 t₁² − 16/3 t₃ + 8/3 t₁t₂ − 8/27 t₁³ + …
/// with t_k = tr E^k.
ElasticConstants constants_at_rest(double f1, double f2, const ElasticConstants& of_volume) {
  return {of_volume.lambda - 4. / 3 * (f1 + f2), 2 * (f1 + f2), -8 * f1 - 16 * f2, of_volume.B + 8. / 3 * f2,
          of_volume.C + 8. / 9 * (f1 - f2)};
}

constexpr std::array chain = {1. / 2, 1. / 20, 11. / 1050, 19. / 7000, 519. / 673750};

double bulk_modulus(const IsochoricNeoHookean& law) { return law.young / (3 * (1 - 2 * law.poisson)); }

Shape shape(const IsochoricNeoHookean& law, double first, double) {
  const double half = shear_modulus(law.young, law.poisson) / 2;
  return {.energy = half * first, .d1 = half};
}
Volume volume(const IsochoricNeoHookean& law, double change) {
  return powers_of_volume(change, {2 / bulk_modulus(law)});
}

Shape shape(const MooneyRivlin& law, double first, double second) {
  return {.energy = law.c10 * first + law.c01 * second, .d1 = law.c10, .d2 = law.c01};
}
Volume volume(const MooneyRivlin& law, double change) { return powers_of_volume(change, {law.d}); }

Shape shape(const Yeoh& law, double y, double) {
  return {.energy = y * (law.c10 + y * (law.c20 + y * law.c30)),
          .d1 = law.c10 + y * (2 * law.c20 + 3 * y * law.c30),
          .d11 = 2 * law.c20 + 6 * y * law.c30};
}
Volume volume(const Yeoh& law, double change) { return powers_of_volume(change, {law.d1, law.d2, law.d3}); }

/// Ī₁^i − 3^i = y (3^(i−1) + 3^(i−2) Ī₁ + … + Ī₁^(i−1)) with y = Ī₁ − 3.
Shape shape(const ArrudaBoyce& law, double y, double) {
  const double stretch = 1 / (law.locking * law.locking), full = 3 + y;
  Shape f{.energy = 0, .d1 = 0};
  double weight = law.mu, sum = 1, power = 1, before = 0;  // of term i: weight, (Ī₁^i − 3^i)/y, Ī₁^(i−1), Ī₁^(i−2)
  double threes = 1;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const double i = static_cast<double>(k + 1), a = weight * chain[k];
    f.energy += a * sum * y;
    f.d1 += a * i * power;
    f.d11 += a * i * (i - 1) * before;
    weight *= stretch;
    threes *= 3;
    before = power;
    power *= full;
    sum = sum * full + threes;
  }
  return f;
}
Volume volume(const ArrudaBoyce& law, double change) {
  const double J = 1 + change;
  return {.energy = (change * change / 2 + less_its_logarithm(change)) / law.d,
          .first = change * (1 + 1 / J) / law.d,
          .second = (1 + 1 / (J * J)) / law.d};
}

template <class Law>
Response response_by(const Law& law, const Matrix<3, 3>& G) {
  const State state(G);
  if (!state.admitted) return unknown();
  return response_of(G, state, shape(law, state.first, state.second), volume(law, state.change));
}

template <class Law>
Moduli moduli_by(const Law& law, const Matrix<3, 3>& G) {
  const State state(G);
  if (!state.admitted) return Moduli::unknown();
  return moduli_of(G, state, shape(law, state.first, state.second), volume(law, state.change));
}

}  // namespace

ElasticConstants IsochoricNeoHookean::at_rest() const {
  const double mu = shear_modulus(young, poisson), bulk = bulk_modulus(*this);
  return {lame_lambda(young, poisson), mu, -4 * mu, -bulk, 1.5 * bulk + 4. / 9 * mu};
}
Response IsochoricNeoHookean::response(const Matrix<3, 3>& G) const { return response_by(*this, G); }
Moduli IsochoricNeoHookean::moduli(const Matrix<3, 3>& G) const { return moduli_by(*this, G); }

std::optional<MooneyRivlin> MooneyRivlin::of_constants(std::span<const double> given) {
  if (given.size() != 3) return std::nullopt;
  return MooneyRivlin{given[0], given[1], given[2]};
}
ElasticConstants MooneyRivlin::at_rest() const { return constants_at_rest(c10, c01, volume_at_rest(d)); }
Response MooneyRivlin::response(const Matrix<3, 3>& G) const { return response_by(*this, G); }
Moduli MooneyRivlin::moduli(const Matrix<3, 3>& G) const { return moduli_by(*this, G); }

std::optional<Yeoh> Yeoh::of_constants(std::span<const double> given) {
  if (given.size() != 4) return std::nullopt;
  return Yeoh{given[0], given[1], given[2], given[3]};
}
ElasticConstants Yeoh::at_rest() const { return constants_at_rest(c10, 0, volume_at_rest(d1)); }
Response Yeoh::response(const Matrix<3, 3>& G) const { return response_by(*this, G); }
Moduli Yeoh::moduli(const Matrix<3, 3>& G) const { return moduli_by(*this, G); }

std::optional<ArrudaBoyce> ArrudaBoyce::of_constants(std::span<const double> given) {
  if (given.size() != 3) return std::nullopt;
  return ArrudaBoyce{given[0], given[1], given[2]};
}
ElasticConstants ArrudaBoyce::at_rest() const {
  ElasticConstants of_volume = volume_at_rest(d);
  of_volume.C -= 1 / d;  // (J² − 1)/2 − ln J = (J−1)² − (J−1)³/3 + …
  return constants_at_rest(shape(*this, 0, 0).d1, 0, of_volume);
}
Response ArrudaBoyce::response(const Matrix<3, 3>& G) const { return response_by(*this, G); }
Moduli ArrudaBoyce::moduli(const Matrix<3, 3>& G) const { return moduli_by(*this, G); }

}  // namespace ritz::fem
