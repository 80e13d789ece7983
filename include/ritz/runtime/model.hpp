// The reduced equation of motion M(q) q̈ + D q̇ + f̃(q) = F(q, t), Eq. 6 of the notes: its constant data. Units are
// those of a mass-orthonormal basis U: reduced coordinates z in √kg m, forces in N/√kg, K̃ in 1/s², D in 1/s.
#pragma once
#include <span>

#include "ritz/runtime/inertia.hpp"
#include "ritz/runtime/internal_force.hpp"

namespace ritz::runtime {

/// A diagonal entry of K̃(0) below this fraction of the largest counts as 0: it belongs to a rigid motion, and is
/// rounding error.
inline constexpr double rigid_stiffness = 1e-10;

/// How a body is damped: D = αM + βK, plus modal damping 2 ζ_i ω_i.
struct Damping {
  double alpha = 0;               ///< α, 1/s
  double beta = 0;                ///< β, s
  std::span<const double> ratio;  ///< ζ of each flexible mode; the last one holds for all further modes; empty: none
};

/// The damping matrix D, 1/s: where it is diagonal only its diagonal, r numbers; else r x r.
template <class Scalar>
using DampingMatrix = std::variant<Vector<Scalar>, Matrix<Scalar>>;

/// The constant data of the equation. Any number of bodies of one kind, and any number of threads, can share it.
template <class Scalar>
struct Model {
  InternalForce<Scalar> force;
  DampingMatrix<Scalar> damping;
  Inertia<Scalar> inertia = UnitInertia{};

  Eigen::Index size() const { return runtime::size(force); }
};

/// The linear model of vibration modes: z_i'' + d_i z_i' + λ_i z_i = f_i with d_i = α + β λ_i + 2 ζ_i ω_i. A rigid mode
/// has λ_i = 0 and d_i = α. Throws InputError for a flexible mode with a negative eigenvalue.
template <class Scalar = double>
Model<Scalar> make_model(const model::Modes& modes, const Damping& damping);

/// The linear model over a basis that does not consist of modes: ω_i² is the diagonal of UᵀKU, where entries below
/// 1e-10 of the largest count as 0.
template <class Scalar = double>
Model<Scalar> make_model(const model::Reduction& reduction, const Damping& damping);

/// The nonlinear model of a polynomial, with D = α I + β K̃(0) + diag(2 ζ_i ω_i) and ω_i² = K̃(0)_ii, as K̃(0) is
/// diagonal over a reduced basis. There D is stored as its diagonal: what rounding leaves beside that of K̃(0), less
/// than 1e-13 of its largest entry, is left out. The ratios ζ are assigned, in order, to the coordinates with a
/// stiffness above rigid_stiffness. Throws InputError as make_polynomial_force does.
template <class Scalar = double>
Model<Scalar> make_model(const model::Polynomial& polynomial, const Damping& damping);

/// The nonlinear model of a cubature, damped as that of a polynomial. `materials` and `polynomial` are those of the
/// body (make_cubature_force, which also says what is thrown).
template <class Scalar = double>
Model<Scalar> make_model(const model::Cubature& cubature, std::span<const model::RegionMaterial> materials,
                         const model::Polynomial* polynomial, const Damping& damping);

/// The model of a body that a rigid frame carries, in the 6 + r coordinates of frame.hpp. Damping does not act on the
/// motion of the frame. `inertia` gives M and h as functions of z and of the velocity ν; neither depends on the frame.
/// Throws std::logic_error where a frame carries the body already.
template <class Scalar>
Model<Scalar> carry(Model<Scalar> body, Inertia<Scalar> inertia);

/// Whether a frame carries the body.
template <class Scalar>
bool is_carried(const Model<Scalar>& model) {
  return std::holds_alternative<CarriedForce<Scalar>>(model.force);
}

/// Whether the model is r independent oscillators: linear, with diagonal damping and unit mass. Such a model is stepped
/// from a table, at a cost of O(r) a step.
template <class Scalar>
bool is_oscillators(const Model<Scalar>& model);

/// y += scale D x; x and y have r entries. Does not allocate.
template <class Scalar>
void add_damping(const Model<Scalar>& model, Scalar scale, const VectorRef<Scalar>& x, Vector<Scalar>& y);
/// matrix += scale D, r x r.
template <class Scalar>
void add_damping(const Model<Scalar>& model, Scalar scale, Matrix<Scalar>& matrix);

/// The energy ½ vᵀMv + Ẽ(z), J. Overwrites `room`. Does not allocate, unless the inertia is a varying one.
template <class Scalar>
Scalar energy(const Model<Scalar>& model, const VectorRef<Scalar>& z, const VectorRef<Scalar>& v,
              Evaluation<Scalar>& room);

}  // namespace ritz::runtime
