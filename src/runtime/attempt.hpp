// One attempt at a part of a step: it solves the equation of the part, and the state is advanced only when that
// succeeds. And the derivative of a part, multiplied by that of the parts before it (chain rule).
#pragma once
#include "ritz/runtime/step.hpp"

namespace ritz::runtime {

/// A part of a step, which begins at `at` and is `width` long, as fractions of the step that are exact in binary.
template <class Scalar>
struct StepPart {
  Scalar at = 0, width = 1;
};

/// y := Σ_c coefficients_c history_c, over the coefficients that are not zero.
template <class Scalar>
void combine(const Matrix<Scalar>& history, const Eigen::Matrix<Scalar, 4, 1>& coefficients, Vector<Scalar>& y);

/// Calls visit(s, weight) for each point z_n + s δ at which the method evaluates forces: one point, or those of the
/// mean.
template <class Scalar, class Visit>
void each_force_point(const Model<Scalar>& model, const ImplicitStep<Scalar>& numbers, Visit&& visit) {
  if (numbers.rule == ForceRule::at_point) return visit(numbers.point, Scalar(1));
  for (const auto [s, weight] : mean_rule(model.force)) visit(s, weight);
}

/// What the derivative of a force at q = z_n + s δ is taken with respect to: q, by the change δ; or small motions of
/// the frame of a carried body at the beginning of the step. For z these are the same.
enum class By : unsigned char { change, beginning };

/// Evaluates a force that depends on the position at q, when the fraction `passed` of the step has passed, and its
/// derivative.
template <class Scalar>
void evaluate_at(const PositionForce<Scalar>& position, const State<Scalar>& state, const Vector<Scalar>& q,
                 Scalar passed, By by, Vector<Scalar>& force, Matrix<Scalar>& tangent);

/// Evaluates the internal force of an implicit method at δ (at the method's point, or its mean over the step), the
/// force that depends on the position, and their derivatives with respect to δ.
template <class Scalar>
void evaluate_forces(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                     const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room);

/// Factors the Jacobian of an implicit method, inertia M + drag D + dF/dδ, where its forces were evaluated last. It is
/// symmetric unless forces depend on the position or the inertia varies.
template <class Scalar>
void factor_jacobian(const Model<Scalar>& model, const StepLoad<Scalar>& load, const ImplicitStep<Scalar>& numbers,
                     NewtonRoom<Scalar>& room);

/// Evaluates a varying inertia at δ; does nothing for a constant one.
template <class Scalar>
void evaluate_inertia(const Model<Scalar>& model, const State<Scalar>& state, const ImplicitStep<Scalar>& numbers,
                      NewtonRoom<Scalar>& room);

/// Whether a linearly implicit method may solve this step by one correction: second derivatives are known of the
/// internal force alone.
template <class Scalar>
bool may_linearise(const Model<Scalar>& model, const StepLoad<Scalar>& load, const ImplicitStep<Scalar>& numbers);

/// Solves the step's equation, from a guess that is good by one correction, else by Newton's method from δ = 0; the
/// solution is room.delta. room.begin and room.end are the loads at the ends of the part. Only where one correction
/// solved it does the outcome of a linearly implicit method have a single evaluation.
template <class Scalar>
Outcome solve_implicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                       const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers,
                       const NewtonOptions<Scalar>& options, NewtonRoom<Scalar>& room);

/// Solves for the acceleration at the end of an explicit step of `dt` seconds: the solution is room.acceleration, and δ
/// is room.delta.
template <class Scalar>
Outcome solve_explicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                       const StepPart<Scalar>& part, const ExplicitStep<Scalar>& numbers, Scalar dt,
                       NewtonRoom<Scalar>& room);

/// For an implicit step, at the solution room.delta, before the state is advanced.
template <class Scalar>
void chain_implicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                    const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room,
                    StepDerivative<Scalar>& derivative);

/// For a step of a linearly implicit method that was solved by one correction, before the state is advanced.
template <class Scalar>
void chain_linearised(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                      const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room,
                      StepDerivative<Scalar>& derivative);

/// For an explicit step, where its forces were evaluated last.
template <class Scalar>
void chain_explicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                    const StepPart<Scalar>& part, const ExplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room,
                    StepDerivative<Scalar>& derivative);

}  // namespace ritz::runtime
