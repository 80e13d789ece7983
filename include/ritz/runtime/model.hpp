// The reduced equation of motion M(q) q̈ + D q̇ + f̃(q) = F(q, t), Eq. 6 of the notes: its constant side.
#pragma once
#include <span>

#include "ritz/runtime/inertia.hpp"
#include "ritz/runtime/internal_force.hpp"

namespace ritz::runtime {

/// A diagonal entry of K̃(0) below this fraction of the largest counts as 0: it is a rigid motion's, known to rounding.
inline constexpr double rigid_stiffness = 1e-10;

/// How a body is damped; the three sum up.
struct Damping {
  double alpha = 0;               ///< 1/s, D = αM + βK
  double beta = 0;                ///< s
  std::span<const double> ratio;  ///< ζ of each flexible mode, the last one held; empty: none
};

/// D, r x r, 1/s: its diagonal alone where there is nothing beside it.
template <class Scalar>
using DampingMatrix = std::variant<Vector<Scalar>, Matrix<Scalar>>;

/// Constant while it runs; shared by any number of bodies of one kind and by any number of threads.
template <class Scalar>
struct Model {
  InternalForce<Scalar> force;
  DampingMatrix<Scalar> damping;
  Inertia<Scalar> inertia = UnitInertia{};

  Eigen::Index size() const { return runtime::size(force); }
};

/// The linear model of vibration modes: z_i'' + d_i z_i' + λ_i z_i = f_i, d_i = α + β λ_i + 2 ζ_i ω_i; a rigid mode has
/// λ = 0 and d = α. Throws InputError for an eigenvalue that is negative.
template <class Scalar = double>
Model<Scalar> make_model(const model::Modes& modes, const Damping& damping);

/// The linear model of a basis that is not of modes: ω_i² is the diagonal of UᵀKU, and below 1e-10 of its largest 0.
template <class Scalar = double>
Model<Scalar> make_model(const model::Reduction& reduction, const Damping& damping);

/// The nonlinear model of a polynomial, D = α I + β K̃(0) + diag(2 ζ_i ω_i). ω_i² is K̃(0)_ii, which is diagonal in a
/// reduced basis; ζ counts the coordinates that have any stiffness. Throws InputError as make_polynomial_force.
template <class Scalar = double>
Model<Scalar> make_model(const model::Polynomial& polynomial, const Damping& damping);

/// The model of a body that a rigid frame carries, in the 6 + r coordinates of frame.hpp. The frame's motion is not
/// damped. `inertia` is M and h by the velocity ν; they do not depend on the frame, which is what makes ν worth using.
template <class Scalar>
Model<Scalar> carry(Model<Scalar> body, Inertia<Scalar> inertia);

/// Whether a frame carries the body.
template <class Scalar>
bool is_carried(const Model<Scalar>& model) {
  return std::holds_alternative<CarriedForce<Scalar>>(model.force);
}

/// Whether the model is r independent oscillators: linear, with diagonal damping and unit mass. They take their steps
/// from a table, O(r) each.
template <class Scalar>
bool is_oscillators(const Model<Scalar>& model);

/// y += scale D x. Does not allocate.
template <class Scalar>
void add_damping(const Model<Scalar>& model, Scalar scale, const VectorRef<Scalar>& x, Vector<Scalar>& y);
/// matrix += scale D, r x r.
template <class Scalar>
void add_damping(const Model<Scalar>& model, Scalar scale, Matrix<Scalar>& matrix);

/// ½ vᵀMv + Ẽ(z), J. Does not allocate where the inertia is constant; `room` is overwritten.
template <class Scalar>
Scalar energy(const Model<Scalar>& model, const VectorRef<Scalar>& z, const VectorRef<Scalar>& v,
              Evaluation<Scalar>& room);

}  // namespace ritz::runtime
