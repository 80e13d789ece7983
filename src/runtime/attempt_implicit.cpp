#include <cmath>
#include <optional>

#include "attempt.hpp"

namespace ritz::runtime {
namespace {

/// How often a correction that enlarges the residual is halved.
constexpr int shortenings = 5;

template <class Scalar>
bool takes_mean(const ImplicitStep<Scalar>& numbers) {
  return numbers.rule == ForceRule::mean_of_step;
}

/// The parts of the equation that δ does not change: loads, and what the history adds to inertia and damping.
template <class Scalar>
void write_target(const Model<Scalar>& model, const State<Scalar>& state, const ImplicitStep<Scalar>& numbers,
                  NewtonRoom<Scalar>& room) {
  combine(state.history, numbers.acceleration, room.acceleration);
  room.target = numbers.begin * room.begin + numbers.end * room.end;
  if (std::holds_alternative<UnitInertia>(model.inertia)) room.target += room.acceleration;
  if (const auto* constant = std::get_if<ConstantInertia<Scalar>>(&model.inertia))
    room.target.noalias() += constant->mass * room.acceleration;
  combine(state.history, numbers.velocity, room.velocity);
  if (!numbers.velocity.isZero(0)) add_damping<Scalar>(model, 1, room.velocity, room.target);
}

/// Evaluates the equation at δ, leaves what is left of it in room.residual and returns what that is measured by.
template <class Scalar>
Scalar evaluate_residual(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                         const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room) {
  evaluate_forces(model, state, load, part, numbers, room);
  const auto& force = takes_mean(numbers) ? room.mean.force : room.at_point.force;
  Scalar scale;
  if (std::holds_alternative<UnitInertia>(model.inertia)) {
    scale = numbers.inertia * room.delta.norm();
    room.residual = numbers.inertia * room.delta + force - room.target;
  } else if (const auto* constant = std::get_if<ConstantInertia<Scalar>>(&model.inertia)) {
    room.residual.noalias() = numbers.inertia * constant->mass * room.delta;
    scale = room.residual.norm();
    room.residual += force - room.target;
  } else {
    evaluate_inertia(model, state, numbers, room);
    scale = room.inertia.force.norm();
    room.residual = room.inertia.force + force - room.target;
  }
  scale += force.norm() + room.target.norm();
  add_damping<Scalar>(model, numbers.drag, room.delta, room.residual);
  if (load.position) {
    room.residual -= room.position_force;
    scale += room.position_force.norm();
  }
  return scale;
}

/// δ −= (the factored matrix)⁻¹ R; returns the length of the change.
template <class Scalar>
Scalar correct(NewtonRoom<Scalar>& room) {
  room.correction = room.residual;
  solve_in_place(room.factors, room.correction);
  room.delta -= room.correction;
  return room.correction.norm();
}

/// The force that depends on the position, at one point or its mean, and its derivative by δ.
template <class Scalar>
void evaluate_position_force(const Model<Scalar>& model, const State<Scalar>& state,
                             const PositionForce<Scalar>& position, const StepPart<Scalar>& part,
                             const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room) {
  room.position_sum.setZero();
  room.position_tangent_sum.setZero();
  each_force_point(model, numbers, [&](Scalar s, Scalar weight) {
    room.position_point = state.z() + s * room.delta;
    evaluate_at(position, state, room.position_point, part.at + s * part.width, By::change, room.position_force,
                room.position_tangent);
    room.position_sum += weight * room.position_force;
    room.position_tangent_sum += (weight * s) * room.position_tangent;
  });
  room.position_force = room.position_sum;
  room.position_tangent = room.position_tangent_sum;
}

/// `off`: δ* − δ.
template <class Scalar>
double local_error(const State<Scalar>& state, const ImplicitStep<Scalar>& numbers, const Vector<Scalar>& off) {
  const Eigen::Index deformed = off.size() - (state.frame ? frame_coordinates : 0);
  return static_cast<double>(numbers.error * off.tail(deformed).norm());
}

/// The first correction of the guess; nothing where the guess is not to be trusted.
template <class Scalar>
std::optional<Outcome> correct_guess(const Model<Scalar>& model, const State<Scalar>& state,
                                     const StepLoad<Scalar>& load, const StepPart<Scalar>& part,
                                     const ImplicitStep<Scalar>& numbers, const NewtonOptions<Scalar>& options,
                                     NewtonRoom<Scalar>& room) {
  combine(state.history, numbers.guess, room.delta);
  const Scalar scale = evaluate_residual(model, state, load, part, numbers, room);
  if (!(room.residual.norm() <= numbers.trust * scale) || options.iterations == 0) return std::nullopt;
  factor_jacobian(model, load, numbers, room);
  if (!std::isfinite(correct(room))) return std::nullopt;
  return Outcome{.iterations = 1, .evaluations = 1, .error = local_error(state, numbers, room.correction)};
}

/// Newton's iteration from δ = 0.
template <class Scalar>
Outcome iterate(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers, const NewtonOptions<Scalar>& options,
                NewtonRoom<Scalar>& room) {
  constexpr Scalar rounding = 8 * std::numeric_limits<Scalar>::epsilon();
  Outcome outcome{.status = Status::not_converged};
  room.delta.setZero();
  // How far the body is from where its coordinates are 0: positions are known to rounding of that.
  const Scalar away = state.z().norm() + (state.frame ? state.frame->origin.norm() : Scalar(0));
  Scalar last = std::numeric_limits<Scalar>::infinity();
  int shortened = 0;
  for (;;) {
    const Scalar scale = evaluate_residual(model, state, load, part, numbers, room);
    ++outcome.evaluations;
    const Scalar size = room.residual.norm();
    const bool started = outcome.iterations > 0;
    if (size == 0 || (started && size <= options.tolerance * scale)) break;
    if (started && !(size <= last) && shortened < shortenings) {  // the correction went too far: take half of it back
      room.correction_taken /= 2;
      room.delta += room.correction_taken;
      ++shortened;
      continue;
    }
    if (!std::isfinite(size)) {
      outcome.status = Status::not_finite;
      return outcome;
    }
    if (outcome.iterations == options.iterations) return outcome;
    last = size;
    shortened = 0;
    factor_jacobian(model, load, numbers, room);
    const Scalar change = correct(room);
    room.correction_taken = room.correction;
    ++outcome.iterations;
    if (change <= rounding * (away + room.delta.norm())) {
      outcome.status = Status::done;  // δ is as good as its last digit, whatever R's rounding
      return outcome;
    }
  }
  // The last factors are at hand: one more correction by them costs next to nothing and makes a small residual tiny.
  if (outcome.iterations > 0) correct(room);
  outcome.status = room.delta.allFinite() ? Status::done : Status::not_finite;
  return outcome;
}

}  // namespace

template <class Scalar>
void combine(const Matrix<Scalar>& history, const Eigen::Matrix<Scalar, 4, 1>& coefficients, Vector<Scalar>& y) {
  y.setZero();
  for (Eigen::Index c = 0; c < history.cols(); ++c)
    if (coefficients[c] != 0) y += coefficients[c] * history.col(c);
}

template <class Scalar>
void evaluate_at(const PositionForce<Scalar>& position, const State<Scalar>& state, const Vector<Scalar>& q,
                 Scalar passed, By by, Vector<Scalar>& force, Matrix<Scalar>& tangent) {
  if (!state.frame) return position({q, nullptr}, passed, force, tangent);
  const FrameChange<Scalar> change = q.template head<frame_coordinates>();
  const auto frame = moved<Scalar>(*state.frame, change);
  position({q, &frame}, passed, force, tangent);
  const auto derivative = moved_derivative<Scalar>(change);
  const auto& motion = by == By::change ? derivative.by_change : derivative.by_frame;
  for (Eigen::Index i = 0; i < tangent.rows(); ++i) {
    const FrameChange<Scalar> row = tangent.row(i).template head<frame_coordinates>();
    tangent.row(i).template head<frame_coordinates>() = row.transpose() * motion;
  }
}

template <class Scalar>
void evaluate_forces(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                     const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room) {
  if (takes_mean(numbers)) {
    evaluate_mean<Scalar>(model.force, state.z(), room.delta, room.mean);
  } else {
    room.point = state.z() + numbers.point * room.delta;
    evaluate<Scalar>(model.force, room.point, room.at_point);
  }
  if (load.position) evaluate_position_force(model, state, *load.position, part, numbers, room);
}

template <class Scalar>
void evaluate_inertia(const Model<Scalar>& model, const State<Scalar>& state, const ImplicitStep<Scalar>& numbers,
                      NewtonRoom<Scalar>& room) {
  if (!std::holds_alternative<VaryingInertia<Scalar>>(model.inertia)) return;
  room.point = state.z() + numbers.point * room.delta;
  room.correction = numbers.drag * room.delta - room.velocity;
  room.residual = numbers.inertia * room.delta - room.acceleration;
  evaluate<Scalar>(model.inertia, room.point, room.correction, room.residual, room.inertia);
}

template <class Scalar>
void factor_jacobian(const Model<Scalar>& model, const StepLoad<Scalar>& load, const ImplicitStep<Scalar>& numbers,
                     NewtonRoom<Scalar>& room) {
  const auto& tangent = takes_mean(numbers) ? room.mean.tangent : room.at_point.tangent;
  const Scalar share = takes_mean(numbers) ? Scalar(1) : numbers.point;
  if (const auto* damping = std::get_if<Matrix<Scalar>>(&model.damping)) {
    room.jacobian = share * tangent + numbers.drag * *damping;  // in one pass, as the matrices fill a cache
  } else {
    room.jacobian = share * tangent;
    add_damping<Scalar>(model, numbers.drag, room.jacobian);
  }
  add_mass(model.inertia, numbers.inertia, room.inertia, room.jacobian);
  const bool varies = std::holds_alternative<VaryingInertia<Scalar>>(model.inertia);
  if (varies) room.jacobian += numbers.drag * room.inertia.by_velocity + numbers.point * room.inertia.by_position;
  if (load.position) room.jacobian -= room.position_tangent;
  if (varies || load.position) factor_unsymmetric(room.jacobian, room.factors);
  else factor(room.jacobian, room.factors);
}

template <class Scalar>
bool may_linearise(const Model<Scalar>& model, const StepLoad<Scalar>& load, const ImplicitStep<Scalar>& numbers) {
  return numbers.trust > 0 && !load.position && !std::holds_alternative<VaryingInertia<Scalar>>(model.inertia);
}

template <class Scalar>
Outcome solve_implicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                       const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers,
                       const NewtonOptions<Scalar>& options, NewtonRoom<Scalar>& room) {
  write_target(model, state, numbers, room);
  const bool guesses = may_linearise(model, load, numbers);
  if (guesses)
    if (const auto once = correct_guess(model, state, load, part, numbers, options, room)) return *once;
  auto outcome = iterate(model, state, load, part, numbers, options, room);
  if (guesses) ++outcome.evaluations;
  if (std::isnan(numbers.error)) return outcome;
  combine(state.history, numbers.guess, room.point);
  room.point -= room.delta;
  outcome.error = local_error(state, numbers, room.point);
  return outcome;
}

#define RITZ_INSTANCE(S)                                                                                      \
  template void combine(const Matrix<S>&, const Eigen::Matrix<S, 4, 1>&, Vector<S>&);                         \
  template void evaluate_at(const PositionForce<S>&, const State<S>&, const Vector<S>&, S, By, Vector<S>&,    \
                            Matrix<S>&);                                                                      \
  template void evaluate_forces(const Model<S>&, const State<S>&, const StepLoad<S>&, const StepPart<S>&,     \
                                const ImplicitStep<S>&, NewtonRoom<S>&);                                      \
  template void factor_jacobian(const Model<S>&, const StepLoad<S>&, const ImplicitStep<S>&, NewtonRoom<S>&); \
  template void evaluate_inertia(const Model<S>&, const State<S>&, const ImplicitStep<S>&, NewtonRoom<S>&);   \
  template bool may_linearise(const Model<S>&, const StepLoad<S>&, const ImplicitStep<S>&);                   \
  template Outcome solve_implicit(const Model<S>&, const State<S>&, const StepLoad<S>&, const StepPart<S>&,   \
                                  const ImplicitStep<S>&, const NewtonOptions<S>&, NewtonRoom<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
