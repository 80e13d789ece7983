// The St. Venant-Kirchhoff law: S = λ tr(E) I + 2μ E, which is Hooke's law between the second Piola-Kirchhoff stress
// and the Green-Lagrange strain.
#pragma once
#include <array>

#include "ritz/fem/law.hpp"

namespace ritz::fem {

/// Valid for young > 0 and -1 < poisson < 1/2. The force is a cubic polynomial in the displacement, so that a reduced
/// model can be exact. The material softens under compression, and does not resist being turned inside out.
struct StVK {
  double young;    ///< Young's modulus, Pa
  double poisson;  ///< Poisson's ratio

  static constexpr std::array parameters = {young_modulus, poisson_ratio};
  std::array<double, 2> values() const { return {young, poisson}; }

  static constexpr const char* name = "stvk";
  static constexpr int force_degree = 3;

  double lambda() const { return lame_lambda(young, poisson); }
  double mu() const { return shear_modulus(young, poisson); }
  ElasticConstants at_rest() const { return {lambda(), mu()}; }

  /// The Green-Lagrange strain E = ½(G + Gᵀ + GᵀG): computed from G, as FᵀF − I would lose the digits of small strains.
  static Matrix<3, 3> strain(const Matrix<3, 3>& G) {
    const Matrix<3, 3> product = G.transpose().lazyProduct(G);
    return (G + G.transpose() + product) / 2;
  }
  /// The second Piola-Kirchhoff stress S, Pa, of a strain E.
  Matrix<3, 3> second_piola(const Matrix<3, 3>& strain) const {
    Matrix<3, 3> S = 2 * mu() * strain;
    S.diagonal().array() += lambda() * strain.trace();
    return S;
  }

  /// W = ½ S : E and P = F S.
  Response response(const Matrix<3, 3>& G) const {
    const Matrix<3, 3> E = strain(G), S = second_piola(E);
    return {S.cwiseProduct(E).sum() / 2, S + G * S};
  }

  /// ∂P_ij/∂F_kl = δ_ik S_lj + λ F_ij F_kl + μ F_il F_kj + μ (FFᵀ)_ik δ_jl.
  Moduli moduli(const Matrix<3, 3>& G) const {
    const Matrix<3, 3> F = Matrix<3, 3>::Identity() + G, S = second_piola(strain(G)), FFt = mu() * F * F.transpose();
    Moduli A = moduli_of_products(F, lambda(), mu());
    for (int j = 0; j < 3; ++j)
      for (int l = 0; l < 3; ++l) {
        auto block = A.block<3, 3>(3 * j, 3 * l);
        block.diagonal().array() += S(l, j);
        if (j == l) block += FFt;
      }
    return A;
  }
};

}  // namespace ritz::fem
