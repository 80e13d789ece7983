// The compressible neo-Hookean law: W = μ/2 (tr FᵀF − 3) − μ ln J + λ/2 ln²J with J = det F [Bonet and Wood 2008, Sec.
// 6.4.3].
#pragma once
#include <array>

#include "ritz/fem/law.hpp"

namespace ritz::fem {

/// Valid for young > 0 and -1 < poisson < 1/2. The energy grows without bound as a cell is compressed to zero volume;
/// states with det F ≤ 0 are not admitted.
struct NeoHookean {
  double young;    ///< Young's modulus at rest, Pa
  double poisson;  ///< Poisson's ratio at rest

  static constexpr std::array parameters = {young_modulus, poisson_ratio};
  std::array<double, 2> values() const { return {young, poisson}; }

  static constexpr const char* name = "neo-hookean";

  double lambda() const { return lame_lambda(young, poisson); }
  double mu() const { return shear_modulus(young, poisson); }
  /// From ln J = tr(E − E² + 4/3 E³ − …).
  ElasticConstants at_rest() const { return {lambda(), mu(), -4 * mu(), -lambda(), 0}; }

  /// P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ.
  Response response(const Matrix<3, 3>& G) const;
  /// ∂P_ij/∂F_kl = μ δ_ik δ_jl + λ B_ij B_kl + (μ − λ ln J) B_il B_kj with B = F⁻ᵀ.
  Moduli moduli(const Matrix<3, 3>& G) const;
};

}  // namespace ritz::fem
