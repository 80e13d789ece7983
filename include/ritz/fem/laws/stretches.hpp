// Laws of the principal stretches λ_a, the singular values of F: Ogden's for rubber, Hencky's of the logarithmic
// strain, and the corotational one, which is Hooke's law between the stretch and its stress. A state with J = det F ≤ 0
// is not admitted by any of them. Stretches that coincide need no care of the user: where two of them meet, difference
// quotients are computed in forms that have no difference in their denominators.
#pragma once
#include <array>
#include <optional>
#include <span>

#include "ritz/fem/law.hpp"

namespace ritz::fem {

/// W = Σ_i 2 μ_i/α_i² (Σ_a λ̄_a^α_i − 3) + (J − 1)²/D₁ + (J − 1)⁴/D₂ + (J − 1)⁶/D₃ with λ̄_a = J^(−1/3) λ_a and up to
/// three terms: those whose μ_i is zero are absent, and so are terms of volume whose D₂ or D₃ is zero [Ogden 1972, in
/// Abaqus's convention for μ_i].
struct Ogden {
  double mu1, alpha1;  ///< Pa, 1; the shear modulus at rest is Σ μ_i
  double mu2 = 0, alpha2 = 1;
  double mu3 = 0, alpha3 = 1;
  double d1;  ///< 1/Pa; the bulk modulus at rest is 2/D₁
  double d2 = 0, d3 = 0;

  static constexpr std::array parameters = {
      energy_coefficient("mu1"), any_number("alpha1"),          energy_coefficient("mu2"),
      any_number("alpha2"),      energy_coefficient("mu3"),     any_number("alpha3"),
      compressibility("d"),      further_compressibility("d2"), further_compressibility("d3")};
  std::array<double, 9> values() const { return {mu1, alpha1, mu2, alpha2, mu3, alpha3, d1, d2, d3}; }
  static constexpr const char* name = "ogden";
  static constexpr const char* constants = "mu1,alpha1[,mu2,alpha2[,mu3,alpha3]],D";
  static std::optional<Ogden> of_constants(std::span<const double> given);

  ElasticConstants at_rest() const;
  Response response(const Matrix<3, 3>& G) const;
  Moduli moduli(const Matrix<3, 3>& G) const;
};

/// W = μ Σ e_a² + λ/2 (Σ e_a)² with the logarithmic strains e_a = ln λ_a [Hencky 1928]. Valid for young > 0 and
/// -1 < poisson < 1/2. It softens beyond stretches of about e.
struct Hencky {
  double young;    ///< Young's modulus, Pa
  double poisson;  ///< Poisson's ratio

  static constexpr std::array parameters = {young_modulus, poisson_ratio};
  std::array<double, 2> values() const { return {young, poisson}; }
  static constexpr const char* name = "hencky";

  ElasticConstants at_rest() const;
  Response response(const Matrix<3, 3>& G) const;
  Moduli moduli(const Matrix<3, 3>& G) const;
};

/// W = μ Σ (λ_a − 1)² + λ/2 (Σ (λ_a − 1))²: the stress is linear in the stretch, whatever the rotation. Valid for
/// young > 0 and -1 < poisson < 1/2. Its energy is finite for a cell that is pressed to nothing.
struct Corotational {
  double young;    ///< Young's modulus, Pa
  double poisson;  ///< Poisson's ratio

  static constexpr std::array parameters = {young_modulus, poisson_ratio};
  std::array<double, 2> values() const { return {young, poisson}; }
  static constexpr const char* name = "corotational";

  ElasticConstants at_rest() const;
  Response response(const Matrix<3, 3>& G) const;
  Moduli moduli(const Matrix<3, 3>& G) const;
};

}  // namespace ritz::fem
