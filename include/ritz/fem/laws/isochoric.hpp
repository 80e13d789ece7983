// Rubber-like laws that split a change of shape from a change of volume: W = f(Ī₁, Ī₂) + U(J), where J = det F, and
// Ī₁ = tr C̄ and Ī₂ = (tr²C̄ − tr C̄²)/2 are the invariants of C̄ = J^(−2/3) FᵀF [Holzapfel, Nonlinear Solid Mechanics,
// Secs. 6.3-6.5]. Constants follow Abaqus's conventions, so that those of a deck can be taken as they are. A state with
// J ≤ 0 is not admitted by any of them.
#pragma once
#include <array>
#include <optional>
#include <span>

#include "ritz/fem/law.hpp"

namespace ritz::fem {

/// W = μ/2 (Ī₁ − 3) + κ/2 (J − 1)², with the shear modulus μ and the bulk modulus κ = E / (3(1−2ν)). Valid for young >
/// 0 and -1 < poisson < 1/2.
struct IsochoricNeoHookean {
  double young;    ///< Young's modulus at rest, Pa
  double poisson;  ///< Poisson's ratio at rest

  static constexpr std::array parameters = {young_modulus, poisson_ratio};
  std::array<double, 2> values() const { return {young, poisson}; }
  static constexpr const char* name = "neo-hookean-isochoric";

  ElasticConstants at_rest() const;
  Response response(const Matrix<3, 3>& G) const;
  Moduli moduli(const Matrix<3, 3>& G) const;
};

/// W = C10 (Ī₁ − 3) + C01 (Ī₂ − 3) + (J − 1)²/D.
struct MooneyRivlin {
  double c10, c01;  ///< Pa; the shear modulus at rest is 2 (C10 + C01)
  double d;         ///< 1/Pa; the bulk modulus at rest is 2/D

  static constexpr std::array parameters = {energy_coefficient("c10"), energy_coefficient("c01"), compressibility("d")};
  std::array<double, 3> values() const { return {c10, c01, d}; }
  static constexpr const char* name = "mooney-rivlin";
  static constexpr const char* constants = "C10,C01,D";
  static std::optional<MooneyRivlin> of_constants(std::span<const double> given);

  ElasticConstants at_rest() const;
  Response response(const Matrix<3, 3>& G) const;
  Moduli moduli(const Matrix<3, 3>& G) const;
};

/// W = C10 (Ī₁ − 3) + C20 (Ī₁ − 3)² + C30 (Ī₁ − 3)³ + (J − 1)²/D₁ + (J − 1)⁴/D₂ + (J − 1)⁶/D₃. A term of volume whose
/// D₂ or D₃ is zero is absent.
struct Yeoh {
  double c10, c20, c30;  ///< Pa; the shear modulus at rest is 2 C10
  double d1;             ///< 1/Pa; the bulk modulus at rest is 2/D₁
  double d2 = 0, d3 = 0;

  static constexpr std::array parameters = {energy_coefficient("c10"),     energy_coefficient("c20"),
                                            energy_coefficient("c30"),     compressibility("d"),
                                            further_compressibility("d2"), further_compressibility("d3")};
  std::array<double, 6> values() const { return {c10, c20, c30, d1, d2, d3}; }
  static constexpr const char* name = "yeoh";
  static constexpr const char* constants = "C10,C20,C30,D";
  static std::optional<Yeoh> of_constants(std::span<const double> given);

  ElasticConstants at_rest() const;
  Response response(const Matrix<3, 3>& G) const;
  Moduli moduli(const Matrix<3, 3>& G) const;
};

/// The chains of a rubber that lock at the stretch λ_m, by five terms of its series [Arruda and Boyce 1993]:
/// W = μ Σ a_i / λ_m^(2i−2) (Ī₁^i − 3^i) + ((J² − 1)/2 − ln J)/D, a = 1/2, 1/20, 11/1050, 19/7000, 519/673750.
struct ArrudaBoyce {
  double mu;       ///< Pa; somewhat below the shear modulus at rest
  double locking;  ///< λ_m
  double d;        ///< 1/Pa; the bulk modulus at rest is 2/D

  static constexpr std::array parameters = {
      positive_modulus("mu"), Parameter{"lambda_m", "locking stretch", "1", 0, std::numeric_limits<double>::infinity()},
      compressibility("d")};
  std::array<double, 3> values() const { return {mu, locking, d}; }
  static constexpr const char* name = "arruda-boyce";
  static constexpr const char* constants = "mu,lambda_m,D";
  static std::optional<ArrudaBoyce> of_constants(std::span<const double> given);

  ElasticConstants at_rest() const;
  Response response(const Matrix<3, 3>& G) const;
  Moduli moduli(const Matrix<3, 3>& G) const;
};

}  // namespace ritz::fem
