#include "ritz/fem/laws/stvk.hpp"

namespace ritz::fem {
namespace {

/// The second Piola-Kirchhoff stress S, Pa, of a strain E.
Matrix<3, 3> second_piola(const StVK& law, const Matrix<3, 3>& strain) {
  Matrix<3, 3> S = 2 * law.mu() * strain;
  S.diagonal().array() += law.lambda() * strain.trace();
  return S;
}

}  // namespace

Matrix<3, 3> StVK::strain(const Matrix<3, 3>& G) {  // FᵀF − I would lose the digits of small strains
  const Matrix<3, 3> product = G.transpose().lazyProduct(G);
  return (G + G.transpose() + product) / 2;
}

Response StVK::response(const Matrix<3, 3>& G) const {
  const Matrix<3, 3> E = strain(G), S = second_piola(*this, E);
  return {S.cwiseProduct(E).sum() / 2, S + G * S};
}

Moduli StVK::moduli(const Matrix<3, 3>& G) const {
  const Matrix<3, 3> F = Matrix<3, 3>::Identity() + G, S = second_piola(*this, strain(G)),
                     FFt = mu() * F * F.transpose();
  Moduli A = moduli_of_products(F, lambda(), mu());
  for (int j = 0; j < 3; ++j)
    for (int l = 0; l < 3; ++l) {
      auto block = A.block<3, 3>(3 * j, 3 * l);
      block.diagonal().array() += S(l, j);
      if (j == l) block += FFt;
    }
  return A;
}

}  // namespace ritz::fem
