// The St. Venant-Kirchhoff law: S = λ tr(E) I + 2μ E, which is Hooke's law between the second Piola-Kirchhoff stress
// and the Green-Lagrange strain.
#pragma once
#include <array>

#include "ritz/fem/law.hpp"

namespace ritz::fem {

/// Lamé's constants λ and μ, Pa.
struct Lame {
  double lambda, mu;
};

/// W = ½ S : E and P = F S.
Response stvk_response(const Lame& lame, const Matrix<3, 3>& G);
/// ∂P_ij/∂F_kl = δ_ik S_lj + λ F_ij F_kl + μ F_il F_kj + μ (FFᵀ)_ik δ_jl.
Moduli stvk_moduli(const Lame& lame, const Matrix<3, 3>& G);

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

  /// The Green-Lagrange strain E = ½(G + Gᵀ + GᵀG).
  static Matrix<3, 3> strain(const Matrix<3, 3>& G);
  Response response(const Matrix<3, 3>& G) const { return stvk_response({lambda(), mu()}, G); }
  Moduli moduli(const Matrix<3, 3>& G) const { return stvk_moduli({lambda(), mu()}, G); }
};

}  // namespace ritz::fem
