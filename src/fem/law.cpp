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

RITZ_WIDE void set_products(const double* B, double a, double b, double* moduli) {
  Column columns[3];
  load(B, columns);
  Column* to = packs(moduli);
  for (int l = 0; l < 3; ++l)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) *to++ = a * B[k + 3 * l] * columns[j] + b * B[k + 3 * j] * columns[l];
}

RITZ_WIDE void add_products(const double* M, const double* S, double* moduli) {
  Column columns[3];
  load(M, columns);
  Column* to = packs(moduli);
  for (int l = 0; l < 3; ++l)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) *to++ += S[j + 3 * l] * columns[k];
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
  add_products(M.data(), S.data(), numbers_.data());
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
