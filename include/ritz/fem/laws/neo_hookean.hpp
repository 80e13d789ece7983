// The compressible neo-Hookean law: W = μ/2 (tr FᵀF − 3) − μ ln J + λ/2 ln²J with J = det F [Bonet and Wood 2008, Sec.
// 6.4.3].
#pragma once
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>

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

  /// P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ = (μ (FFᵀ − I) + λ ln J I) F⁻ᵀ. It is computed from G so that small strains keep
  /// their digits: W = μ (½ G : G − (J − 1 − tr G) + (J − 1 − ln J)) + λ/2 ln²J.
  Response response(const Matrix<3, 3>& G) const {
    const double beyond = nonlinear_volume_change(G), change = G.trace() + beyond;
    if (!(change > -1)) return unknown();
    const double log = std::log1p(change);
    const Matrix<3, 3> F = Matrix<3, 3>::Identity() + G;
    Matrix<3, 3> stretch = mu() * (G + G.transpose() + G * G.transpose());
    stretch.diagonal().array() += lambda() * log;
    const double energy = mu() * (G.squaredNorm() / 2 - beyond + less_its_logarithm(change)) + lambda() / 2 * log * log;
    return {energy, stretch * F.inverse().transpose()};
  }

  /// ∂P_ij/∂F_kl = μ δ_ik δ_jl + λ B_ij B_kl + (μ − λ ln J) B_il B_kj with B = F⁻ᵀ.
  Moduli moduli(const Matrix<3, 3>& G) const {
    const double change = G.trace() + nonlinear_volume_change(G);
    if (!(change > -1)) return Moduli::Constant(std::numeric_limits<double>::quiet_NaN());
    const Matrix<3, 3> B = (Matrix<3, 3>::Identity() + G).inverse().transpose();
    Moduli A = moduli_of_products(B, lambda(), mu() - lambda() * std::log1p(change));
    A.diagonal().array() += mu();
    return A;
  }
};

}  // namespace ritz::fem
