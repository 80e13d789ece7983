// What a material law is: the stored energy and the stress of a material as functions of the displacement gradient.
//
// u is the displacement, G = ∇u (G_ij = ∂u_i/∂X_j) its gradient, and F = I + G the deformation gradient. A law is given
// G instead of F, because small strains would lose digits in F.
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "ritz/fem/types.hpp"

namespace ritz::fem {

/// The response of a law at one point. For a state that the law does not admit (such as det F ≤ 0 under a logarithm)
/// energy and stress are NaN; solvers reject such a state.
struct Response {
  double energy;        ///< W, J per m³ of the body at rest
  Matrix<3, 3> stress;  ///< first Piola-Kirchhoff stress P = ∂W/∂F, Pa
};

/// The tangent moduli A_ijkl = ∂P_ij/∂F_kl, Pa, symmetric: A_ijkl = A_klij. The numbers of equal j, k and l stand
/// together, three and one of padding, so that they fill a register.
class Moduli {
 public:
  /// Without values: of_products and unknown set all of them.
  Moduli() {}

  /// a B_ij B_kl + b B_il B_kj, of which the moduli of many laws are composed.
  static Moduli of_products(const Matrix<3, 3>& B, double a, double b);
  /// Those of a state that the law does not admit: NaN.
  static Moduli unknown();
  /// Adds M_ik S_jl, with M and S symmetric.
  void add_product(const Matrix<3, 3>& M, const Matrix<3, 3>& S);
  /// Adds a B_ij B_kl + b B_il B_kj.
  void add_products(const Matrix<3, 3>& B, double a, double b);
  /// Adds a (X_ij Y_kl + Y_ij X_kl).
  void add_dyads(const Matrix<3, 3>& X, const Matrix<3, 3>& Y, double a);

  double operator()(int i, int j, int k, int l) const { return numbers_[static_cast<std::size_t>(place(j, k, l) + i)]; }
  double& operator()(int i, int j, int k, int l) { return numbers_[static_cast<std::size_t>(place(j, k, l) + i)]; }
  /// The four numbers of j, k and l, aligned to 32 bytes; those of the next k or l follow as place() says.
  const double* data() const { return numbers_.data(); }
  static constexpr int place(int j, int k, int l) { return 4 * (9 * l + 3 * k + j); }

 private:
  alignas(32) std::array<double, 108> numbers_;
};

/// Where component ij of a symmetric tensor stands among xx yy zz xy yz zx.
constexpr int strain_component(int i, int j) { return i == j ? i : i + j == 1 ? 3 : i + j == 3 ? 4 : 5; }

/// A law near rest. An isotropic one is given by Lamé's constants and Landau's three constants of third order, all in
/// Pa: W = λ/2 tr²E + μ tr E² + A/3 tr E³ + B tr E tr E² + C/3 tr³E + O(E⁴), where E is the Green-Lagrange strain
/// [Landau and Lifshitz, Theory of Elasticity, § 26]. Vibration modes depend on λ and μ, modal derivatives on all five.
/// For an anisotropic law W = ½ E : C : E + O(E⁴); λ and μ are NaN then, so that nothing can take them by mistake.
struct ElasticConstants {
  double lambda, mu;
  double A = 0, B = 0, C = 0;
  /// C where the law is anisotropic: the stress xx yy zz xy yz zx of the strain xx yy zz 2xy 2yz 2zx, Pa.
  std::optional<Matrix<6, 6>> moduli = {};

  static ElasticConstants anisotropic(const Matrix<6, 6>& moduli);

  /// Young's modulus, Pa, and Poisson's ratio; of an anisotropic law those of its mean over all directions (Voigt's).
  double young() const;
  double poisson() const;
  /// The largest modulus of a strain in one direction, λ + 2μ, Pa.
  double stiffest() const;
  /// C of either kind of law.
  Matrix<6, 6> hooke() const;
  bool has_third_order() const { return A != 0 || B != 0 || C != 0; }
};

/// Lamé's first parameter λ = Eν / ((1+ν)(1−2ν)), Pa.
inline double lame_lambda(double young, double poisson) {
  return young * poisson / ((1 + poisson) * (1 - 2 * poisson));
}
/// The shear modulus μ = E / (2(1+ν)), Pa.
inline double shear_modulus(double young, double poisson) { return young / (2 * (1 + poisson)); }

/// A parameter of a law, and the open interval (above, below) in which its value must lie.
struct Parameter {
  const char* name;   ///< in options and files
  const char* words;  ///< in messages
  const char* units;
  double above, below;
};

inline constexpr Parameter young_modulus = {"young", "Young's modulus", "Pa", 0,
                                            std::numeric_limits<double>::infinity()};
inline constexpr Parameter poisson_ratio = {"poisson", "Poisson's ratio", "1", -1, .5};

/// A number without units that may be any.
constexpr Parameter any_number(const char* name) {
  return {name, name, "1", -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}
/// A modulus that must be positive.
constexpr Parameter positive_modulus(const char* name) {
  return {name, name, "Pa", 0, std::numeric_limits<double>::infinity()};
}
/// A coefficient of an energy density, of either sign.
constexpr Parameter energy_coefficient(const char* name) {
  return {name, name, "Pa", -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}
/// The D of an energy (J − 1)²/D.
constexpr Parameter compressibility(const char* name) {
  return {name, name, "1/Pa", 0, std::numeric_limits<double>::infinity()};
}
/// The D₂ or D₃ of a term (J − 1)⁴/D₂ or (J − 1)⁶/D₃, which is absent where it is zero.
constexpr Parameter further_compressibility(const char* name) {
  return {name, name, "1/Pa", -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

/// A law is a struct of its parameters, in the order of L::parameters, with these members. It must have no stress at
/// rest: response(0) is zero.
template <class L>
concept Law = requires(const L& law, const Matrix<3, 3>& G) {
  { L::name } -> std::convertible_to<const char*>;  ///< as users write it
  { L::parameters[0] } -> std::convertible_to<Parameter>;
  { law.values()[0] } -> std::convertible_to<double>;
  { law.response(G) } -> std::same_as<Response>;
  { law.moduli(G) } -> std::same_as<Moduli>;
  { law.at_rest() } -> std::same_as<ElasticConstants>;
};

/// A law whose parameters users give as a list, `-material_constants`: L::constants names them in their order, and
/// L::of_constants makes the law of them, or nothing if their number is wrong.
template <class L>
concept LawOfConstants = Law<L> && requires(std::span<const double> given) {
  { L::constants } -> std::convertible_to<const char*>;
  { L::of_constants(given) } -> std::same_as<std::optional<L>>;
};

/// A law whose force is a polynomial in the displacement, of degree L::force_degree. It is required where a computation
/// is exact for such laws only.
template <class L>
concept PolynomialLaw = Law<L> && requires {
  { L::force_degree } -> std::convertible_to<int>;
};

/// J − 1 − tr G = det(I + G) − 1 − tr G, with full relative precision for small G.
double nonlinear_volume_change(const Matrix<3, 3>& G);

/// x − ln(1 + x), with full relative precision for small x.
double less_its_logarithm(double x);

/// The response to a state that a law does not admit: NaN.
Response unknown();

}  // namespace ritz::fem
