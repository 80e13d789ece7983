// One attempt at a part of a step: its equation is solved, or not; the state is only read until it is.
#pragma once
#include "ritz/runtime/step_derivative.hpp"

namespace ritz::runtime {

/// A part of a step: from `at` on, `width` of the whole, which are fractions exact in binary.
template <class Scalar>
struct StepPart {
  Scalar at = 0, width = 1;
};

/// y = Σ_c coefficients_c history_c, over the coefficients that are not zero.
template <class Scalar>
void combine(const Matrix<Scalar>& history, const Eigen::Matrix<Scalar, 4, 1>& coefficients, Vector<Scalar>& y);

/// visit(s, weight) for each point z_n + s δ at which the method takes forces: one, or those of the mean.
template <class Scalar, class Visit>
void each_force_point(const ImplicitStep<Scalar>& numbers, Visit&& visit) {
  if (numbers.rule == ForceRule::at_point) return visit(numbers.point, Scalar(1));
  for (const Scalar s : mean_points<Scalar>()) visit(s, Scalar(0.5));
}

/// What a derivative is by where a frame moves: by the change that moves it, or by small motions of the frame at the
/// beginning of the step, by its axes then. Of z the two are the same.
enum class By : unsigned char { change, beginning };

/// The force of position at q = z_n + s δ, after `passed` of the whole step, and its derivative.
template <class Scalar>
void evaluate_at(const PositionForce<Scalar>& position, const State<Scalar>& state, const Vector<Scalar>& q,
                 Scalar passed, By by, Vector<Scalar>& force, Matrix<Scalar>& tangent);

/// The internal force of an implicit method at δ, its mean over the step or at the method's point, and the force that
/// depends on the position; with their derivatives by δ.
template <class Scalar>
void evaluate_forces(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                     const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room);

/// Factors the matrix inertia M + drag D + dF/dδ of an implicit method where its forces were evaluated last. It is
/// symmetric unless forces depend on the position or the inertia varies.
template <class Scalar>
void factor_jacobian(const Model<Scalar>& model, const StepLoad<Scalar>& load, const ImplicitStep<Scalar>& numbers,
                     NewtonRoom<Scalar>& room);

/// Evaluates a varying inertia at δ; nothing of a constant one.
template <class Scalar>
void evaluate_inertia(const Model<Scalar>& model, const State<Scalar>& state, const ImplicitStep<Scalar>& numbers,
                      NewtonRoom<Scalar>& room);

/// Solves the step's equation from δ = 0 into room.delta, by Newton's method. The loads are those of the part, in
/// room.begin and room.end.
template <class Scalar>
Outcome solve_implicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                       const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers,
                       const NewtonOptions<Scalar>& options, NewtonRoom<Scalar>& room);

/// Solves for the acceleration at the end of an explicit step of `dt` seconds into room.acceleration; its δ is in
/// room.delta then.
template <class Scalar>
Outcome solve_explicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                       const StepPart<Scalar>& part, const ExplicitStep<Scalar>& numbers, Scalar dt,
                       NewtonRoom<Scalar>& room);

}  // namespace ritz::runtime
