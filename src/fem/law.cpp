#include "ritz/fem/law.hpp"

#include <cmath>
#include <limits>

#include "ritz/base/simd.hpp"

namespace ritz::fem {
namespace {

using Column = Pack<double>;  // three numbers and one of padding

RITZ_INLINE void load(const double* matrix, Column (&columns)[3]) {
  for (int j = 0; j < 3; ++j) columns[j] = Column{matrix[3 * j], matrix[3 * j + 1], matrix[3 * j + 2], 0};
}

/// Calls put(place, value) with the columns a B_ij B_kl + b B_il B_kj.
template <class Put>
RITZ_INLINE void each_product(const double* B, double a, double b, Column* to, Put put) {
  Column columns[3];
  load(B, columns);
  for (int l = 0; l < 3; ++l)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) put(*to++, a * B[k + 3 * l] * columns[j] + b * B[k + 3 * j] * columns[l]);
}

struct Set {
  RITZ_INLINE void operator()(Column& place, const Column& value) const { place = value; }
};
struct Add {
  RITZ_INLINE void operator()(Column& place, const Column& value) const { place += value; }
};

RITZ_WIDE void set_products(const double* B, double a, double b, double* moduli) {
  each_product(B, a, b, packs(moduli), Set());
}

RITZ_WIDE void add_dyad_and_crossed(const double* B, double a, double b, double* moduli) {
  each_product(B, a, b, packs(moduli), Add());
}

RITZ_WIDE void add_both_dyads(const double* X, const double* Y, double a, double* moduli) {
  Column x[3], y[3];
  load(X, x);
  load(Y, y);
  Column* to = packs(moduli);
  for (int l = 0; l < 3; ++l)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) *to++ += a * Y[k + 3 * l] * x[j] + a * X[k + 3 * l] * y[j];
}

RITZ_WIDE void add_blocks(const double* M, const double* S, double* moduli) {
  Column columns[3];
  load(M, columns);
  Column* to = packs(moduli);
  for (int l = 0; l < 3; ++l)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) *to++ += S[j + 3 * l] * columns[k];
}

/// The bulk modulus and the shear modulus of Voigt's mean.
std::array<double, 2> voigt(const Matrix<6, 6>& C) {
  const double direct = C(0, 0) + C(1, 1) + C(2, 2), cross = C(0, 1) + C(1, 2) + C(2, 0);
  return {(direct + 2 * cross) / 9, (direct - cross + 3 * (C(3, 3) + C(4, 4) + C(5, 5))) / 15};
}

}  // namespace

Moduli Moduli::of_products(const Matrix<3, 3>& B, double a, double b) {
  Moduli result;
  set_products(B.data(), a, b, result.numbers_.data());
  return result;
}

Moduli Moduli::unknown() {
  Moduli result;
  result.numbers_.fill(std::numeric_limits<double>::quiet_NaN());
  return result;
}

void Moduli::add_product(const Matrix<3, 3>& M, const Matrix<3, 3>& S) {
  add_blocks(M.data(), S.data(), numbers_.data());
}

void Moduli::add_products(const Matrix<3, 3>& B, double a, double b) {
  add_dyad_and_crossed(B.data(), a, b, numbers_.data());
}

void Moduli::add_dyads(const Matrix<3, 3>& X, const Matrix<3, 3>& Y, double a) {
  add_both_dyads(X.data(), Y.data(), a, numbers_.data());
}

ElasticConstants ElasticConstants::anisotropic(const Matrix<6, 6>& moduli) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {.lambda = none, .mu = none, .moduli = moduli};
}

double ElasticConstants::young() const {
  if (!moduli) return mu * ((3 * lambda + 2 * mu) / (lambda + mu));  // squares may be beyond numbers
  const auto [bulk, shear] = voigt(*moduli);
  return shear * (9 * bulk / (3 * bulk + shear));
}

double ElasticConstants::poisson() const {
  if (!moduli) return lambda / (2 * (lambda + mu));
  const auto [bulk, shear] = voigt(*moduli);
  return (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
}

double ElasticConstants::stiffest() const { return moduli ? moduli->diagonal().head<3>().maxCoeff() : lambda + 2 * mu; }

Matrix<6, 6> ElasticConstants::hooke() const {
  if (moduli) return *moduli;
  Matrix<6, 6> C = Matrix<6, 6>::Zero();
  C.topLeftCorner<3, 3>().setConstant(lambda);
  C.diagonal() << lambda + 2 * mu, lambda + 2 * mu, lambda + 2 * mu, mu, mu, mu;
  return C;
}

double nonlinear_volume_change(const Matrix<3, 3>& G) {
  const double minors = G(0, 0) * G(1, 1) - G(0, 1) * G(1, 0) + G(1, 1) * G(2, 2) - G(1, 2) * G(2, 1) +
                        G(2, 2) * G(0, 0) - G(2, 0) * G(0, 2);
  const double determinant = G(0, 0) * (G(1, 1) * G(2, 2) - G(1, 2) * G(2, 1)) -
                             G(0, 1) * (G(1, 0) * G(2, 2) - G(1, 2) * G(2, 0)) +
                             G(0, 2) * (G(1, 0) * G(2, 1) - G(1, 1) * G(2, 0));
  return minors + determinant;
}

double less_its_logarithm(double x) {  // ln(1 + x) = 2 artanh(x / (2 + x))
  if (std::abs(x) > .25) return x - std::log1p(x);
  const double s = x / (2 + x), square = s * s;
  double tail = 0;  // Σ s^(2k) / (2k + 1) for k = 1, 2, …, the last term below 1e-17
  for (int k = 9; k > 0; --k) tail = square * (tail + 1. / (2 * k + 1));
  return s * (x - 2 * tail);
}

Response unknown() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, Matrix<3, 3>::Constant(nan)};
}

}  // namespace ritz::fem
