#include "ritz/fem/laws/stvk.hpp"

namespace ritz::fem {
namespace {

/// AᵀA, by its six different entries.
Matrix<3, 3> gram(const Matrix<3, 3>& A) {
  Matrix<3, 3> products;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i <= j; ++i)
      products(i, j) = products(j, i) = A(0, i) * A(0, j) + A(1, i) * A(1, j) + A(2, i) * A(2, j);
  return products;
}

/// The second Piola-Kirchhoff stress S, Pa, of a strain E.
Matrix<3, 3> second_piola(const Lame& lame, const Matrix<3, 3>& strain) {
  Matrix<3, 3> S = 2 * lame.mu * strain;
  S.diagonal().array() += lame.lambda * strain.trace();
  return S;
}

}  // namespace

Matrix<3, 3> StVK::strain(const Matrix<3, 3>& G) {  // FᵀF − I would lose the digits of small strains
  return (G + G.transpose() + gram(G)) / 2;
}

Response stvk_response(const Lame& lame, const Matrix<3, 3>& G) {
  const Matrix<3, 3> E = StVK::strain(G), S = second_piola(lame, E);
  return {S.cwiseProduct(E).sum() / 2, S + G * S};
}

Moduli stvk_moduli(const Lame& lame, const Matrix<3, 3>& G) {
  const Matrix<3, 3> I = Matrix<3, 3>::Identity(), F = I + G;
  Moduli A = Moduli::of_products(F, lame.lambda, lame.mu);
  A.add_product(I, second_piola(lame, StVK::strain(G)));
  A.add_product(lame.mu * gram(F.transpose()), I);
  return A;
}

}  // namespace ritz::fem
