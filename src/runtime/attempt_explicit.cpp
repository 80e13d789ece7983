#include "attempt.hpp"

namespace ritz::runtime {
namespace {

/// A varying inertia is solved for again with the velocity that its solution means, at most so often.
constexpr int repeats_of_varying = 50;

/// Factors M + drag D.
template <class Scalar>
void factor_mass(const Model<Scalar>& model, Scalar drag, NewtonRoom<Scalar>& room) {
  room.jacobian.setZero();
  add_damping<Scalar>(model, drag, room.jacobian);
  add_mass(model.inertia, Scalar(1), room.inertia, room.jacobian);
  factor(room.jacobian, room.factors);
}

/// M(q) a + h(q, v) + drag D a = target with v = drag a + velocity: corrected by M + drag D until a does not change.
template <class Scalar>
Status solve_varying(const Model<Scalar>& model, const ExplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room) {
  constexpr Scalar rounding = 4 * std::numeric_limits<Scalar>::epsilon();
  room.acceleration.setZero();
  for (int n = 0; n < repeats_of_varying; ++n) {
    room.correction = room.velocity + numbers.drag * room.acceleration;
    evaluate<Scalar>(model.inertia, room.point, room.correction, room.acceleration, room.inertia);
    if (n == 0) factor_mass(model, numbers.drag, room);
    room.residual = room.inertia.force - room.target;
    add_damping<Scalar>(model, numbers.drag, room.acceleration, room.residual);
    solve_in_place(room.factors, room.residual);
    room.acceleration -= room.residual;
    if (!room.acceleration.allFinite()) return Status::not_finite;
    if (room.residual.norm() <= rounding * room.acceleration.norm()) return Status::done;
  }
  return Status::not_converged;
}

}  // namespace

template <class Scalar>
Outcome solve_explicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                       const StepPart<Scalar>& part, const ExplicitStep<Scalar>& numbers, Scalar dt,
                       NewtonRoom<Scalar>& room) {
  combine(state.history, numbers.displacement, room.delta);
  combine(state.history, numbers.velocity, room.velocity);
  room.point = state.z() + room.delta;
  evaluate<Scalar>(model.force, room.point, room.at_point);
  room.target = room.end - room.at_point.force;
  add_damping<Scalar>(model, -1, room.velocity, room.target);
  if (load.position) {
    evaluate_at(*load.position, state, room.point, part.at + part.width, By::change, room.position_force,
                room.position_tangent);
    room.target += room.position_force;
  }
  if (std::holds_alternative<VaryingInertia<Scalar>>(model.inertia))
    return {.status = solve_varying(model, numbers, room), .evaluations = 1};
  if (room.factored_dt != dt) factor_mass(model, numbers.drag, room);
  room.factored_dt = dt;
  room.acceleration = room.target;
  solve_in_place(room.factors, room.acceleration);
  return {.status = room.acceleration.allFinite() ? Status::done : Status::not_finite, .evaluations = 1};
}

#define RITZ_INSTANCE(S)                                                                                    \
  template Outcome solve_explicit(const Model<S>&, const State<S>&, const StepLoad<S>&, const StepPart<S>&, \
                                  const ExplicitStep<S>&, S, NewtonRoom<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
