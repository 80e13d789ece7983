// The force of a cubature (model::Cubature): energy, force and tangent of any law at T cells of the mesh,
//
//   Ẽ = Σ_p v_p W(G_p),  f̃ = Σ_p v_p Γ_pᵀ P(G_p),  K̃ = Σ_p v_p Γ_pᵀ A(G_p) Γ_p,  G_p = Γ_p z,
//
// where Γ_p (9 x r) holds the displacement gradients of the columns of U at a quadrature point, v_p is its volume times
// the weight of its cell, P = ∂W/∂F and A = ∂P/∂F. With a polynomial, which has the energy of St. Venant-Kirchhoff laws
// of the same constants at rest, W is the difference to those, and the polynomial's results are added.
//
// A few points are taken at a time, so that all that belongs to them stays in the fastest cache.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "ritz/fem/material.hpp"
#include "ritz/runtime/polynomial_force.hpp"

namespace ritz::runtime {

/// The points of one law, which follow those of the law before.
struct CubaturePoints {
  fem::Material material;
  std::optional<fem::Lame> less;  ///< the St. Venant-Kirchhoff law that the polynomial has already
  Eigen::Index first, count;
};

/// A cubature in the order in which it is evaluated. Laws are computed in double precision, whatever the scalar.
/// Evaluating does not change it: any number of threads can share it.
template <class Scalar>
struct CubatureForce {
  Eigen::Index r = 0;
  std::vector<CubaturePoints> laws;
  std::vector<double> volumes;      ///< v, one a point, m³
  AlignedVector<Scalar> gradients;  ///< Γᵀ of all points: 9 columns a point, each of r numbers and zeros up to a
                                    ///< multiple of two registers
  std::optional<PolynomialForce<Scalar>> polynomial;

  Eigen::Index size() const { return r; }
};

/// Brings a cubature into that order. `materials` are those of the body's regions, and `polynomial` is the body's where
/// the integrand is what that one lacks. Throws InputError when shapes do not fit each other, when a weight is not
/// positive, and when the law of a cell is a polynomial, of which nothing is lacking.
template <class Scalar>
CubatureForce<Scalar> make_cubature_force(const model::Cubature& cubature,
                                          std::span<const model::RegionMaterial> materials,
                                          const model::Polynomial* polynomial);

/// Allocates the result of evaluate.
template <class Scalar>
Evaluation<Scalar> make_evaluation(const CubatureForce<Scalar>& force);

/// Writes Ẽ, f̃ and K̃ at z, r numbers, to `result`. Does not allocate. NaN where a law does not admit the state of a
/// point, such as a volume that is not positive.
template <class Scalar>
void evaluate(const CubatureForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& result);

/// Whether the laws admit the state at z: whether evaluate would find a finite energy. Overwrites `room`, of which
/// energy, force and tangent stay as they are. Costs a fraction of an evaluation, and does not allocate.
template <class Scalar>
bool admits(const CubatureForce<Scalar>& force, const VectorRef<Scalar>& z, Evaluation<Scalar>& room);

/// K̃(0), r x r, 1/s².
template <class Scalar>
Matrix<Scalar> stiffness_at_rest(const CubatureForce<Scalar>& force);

}  // namespace ritz::runtime
