// The orthotropic St. Venant-Kirchhoff law: S = C : E between the second Piola-Kirchhoff stress and the Green-Lagrange
// strain, with nine constants along three axes of the material.
#pragma once
#include <array>
#include <optional>
#include <span>

#include "ritz/fem/law.hpp"

namespace ritz::fem {

/// The strain E₁₁ = S₁₁/E₁ − ν₁₂ S₂₂/E₁ − ν₁₃ S₃₃/E₁ and so on, 2E₁₂ = S₁₂/G₁₂, in axes of which the first points along
/// `axes`' first three numbers, and the second lies in the plane of both triples [Abaqus's ENGINEERING CONSTANTS].
/// Valid where C is positive definite. Its force is a cubic polynomial in the displacement, as that of StVK.
class OrthotropicStVK {
 public:
  /// The parameters in their order.
  static constexpr std::array parameters = {positive_modulus("e1"),  positive_modulus("e2"),  positive_modulus("e3"),
                                            any_number("nu12"),      any_number("nu13"),      any_number("nu23"),
                                            positive_modulus("g12"), positive_modulus("g13"), positive_modulus("g23"),
                                            any_number("axis1_x"),   any_number("axis1_y"),   any_number("axis1_z"),
                                            any_number("axis2_x"),   any_number("axis2_y"),   any_number("axis2_z")};
  using Values = std::array<double, parameters.size()>;

  explicit OrthotropicStVK(const Values& values);
  template <class... Number>
  explicit OrthotropicStVK(Number... values) : OrthotropicStVK(Values{values...}) {}

  Values values() const { return values_; }
  static constexpr const char* name = "stvk-orthotropic";
  static constexpr const char* constants = "E1,E2,E3,nu12,nu13,nu23,G12,G13,G23";
  static constexpr int force_degree = 3;
  /// Along the axes of the coordinates.
  static std::optional<OrthotropicStVK> of_constants(std::span<const double> given);

  ElasticConstants at_rest() const;
  /// The sine of the angle between the two given axes, which span a plane only if it is positive.
  double angle_of_axes() const;

  Response response(const Matrix<3, 3>& G) const;
  /// ∂P_ij/∂F_kl = δ_ik S_lj + F_im C_mjnl F_kn.
  Moduli moduli(const Matrix<3, 3>& G) const;

 private:
  Values values_;
  Matrix<6, 6> hooke_;  ///< C in the coordinates of the mesh
};

}  // namespace ritz::fem
