#include "ritz/fem/law.hpp"

#include <cmath>

namespace ritz::fem {

Moduli moduli_of_products(const Matrix<3, 3>& B, double a, double b) {
  Moduli A;
  for (int l = 0; l < 3; ++l)
    for (int j = 0; j < 3; ++j)
      A.block<3, 3>(3 * j, 3 * l) = a * B.col(j) * B.col(l).transpose() + b * B.col(l) * B.col(j).transpose();
  return A;
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
