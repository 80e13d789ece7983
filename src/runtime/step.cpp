#include "ritz/runtime/step.hpp"

#include <algorithm>
#include <cmath>

#include "attempt.hpp"
#include "oscillator_tables.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/runtime/symmetric_eigen.hpp"

namespace ritz::runtime {
namespace {

/// The highest frequency at rest, rad/s.
template <class Scalar>
double highest_frequency(const Model<Scalar>& model) {
  const Vector<Scalar> rest = Vector<Scalar>::Zero(model.size());
  auto inertia = make_inertia_at<Scalar>(model.size());
  evaluate<Scalar>(model.inertia, rest, rest, rest, inertia);
  const Eigen::MatrixXd stiffness = stiffness_at_rest(model.force).template cast<double>();
  const double largest = std::holds_alternative<UnitInertia>(model.inertia)
                             ? eigenvalues(stiffness).maxCoeff()
                             : eigenvalues(stiffness, inertia.mass.template cast<double>()).maxCoeff();
  return std::sqrt(std::max(0.0, largest));
}

template <class Scalar>
NewtonRoom<Scalar> make_room(const Model<Scalar>& model, const Integrator& integrator, Loads loads) {
  const Eigen::Index r = model.size();
  const Vector<Scalar> none = Vector<Scalar>::Zero(r);
  const Matrix<Scalar> square = Matrix<Scalar>::Zero(r, r);
  const bool varies = std::holds_alternative<VaryingInertia<Scalar>>(model.inertia);
  NewtonRoom<Scalar> room{.at_point = make_evaluation(model.force),
                          .mean = make_mean_evaluation(model.force),
                          .inertia = make_inertia_at<Scalar>(varies ? r : 0),
                          .jacobian = square,
                          .factors = make_factors<Scalar>(r),
                          .next = Matrix<Scalar>::Zero(r, history_size(integrator.history)),
                          .before = {.history = Matrix<Scalar>::Zero(r, history_size(integrator.history))}};
  for (auto* vector : {&room.target, &room.acceleration, &room.velocity, &room.delta, &room.point, &room.residual,
                       &room.correction, &room.correction_taken, &room.begin, &room.end})
    *vector = none;
  if (loads == Loads::of_position) {
    room.position_tangent = room.position_tangent_sum = square;
    room.position_force = room.position_point = room.position_sum = none;
  }
  if (std::holds_alternative<ExplicitStep<>>(integrator.step)) room.highest_frequency = highest_frequency(model);
  return room;
}

/// y_c := Σ_j history_cj y_j + change_c x of each coordinate.
template <class Scalar, class Numbers>
void advance(const Numbers& numbers, const Vector<Scalar>& unknown, Scalar dt, Matrix<Scalar>& next,
             State<Scalar>& state) {
  const Eigen::Index width = state.history.cols();
  for (Eigen::Index c = 0; c < width; ++c) {
    next.col(c) = numbers.change[c] * unknown;
    for (Eigen::Index j = 0; j < width; ++j)
      if (numbers.history(c, j) != 0) next.col(c) += numbers.history(c, j) * state.history.col(j);
  }
  state.history.swap(next);
  state.last_dt = dt;
  if (!state.frame) return;
  *state.frame = moved<Scalar>(*state.frame, state.history.col(0).template head<frame_coordinates>());
  state.history.col(0).template head<frame_coordinates>().setZero();
}

/// One attempt at a part of a step; advances the state where it succeeds.
template <class Scalar>
Outcome attempt(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load,
                const StepPart<Scalar>& part, Scalar dt, Workspace<Scalar>& workspace,
                StepDerivative<Scalar>* derivative) {
  const auto& integrator = workspace.integrator;
  auto& room = std::get<NewtonRoom<Scalar>>(workspace.room);
  if (const auto* method = std::get_if<ExplicitStep<>>(&integrator.step)) {
    const auto numbers = scaled(*method, integrator.history, dt);
    const auto outcome = solve_explicit(model, state, load, part, numbers, dt, room);
    if (outcome.status != Status::done) return outcome;
    if (derivative) chain_explicit(model, state, load, part, numbers, room, *derivative);
    room.velocity = state.velocity();
    advance(numbers, room.acceleration, dt, room.next, state);
    // Work is counted along the mean of the velocities, as the kinetic energy is: along the displacement it lags
    // behind.
    room.delta = dt / 2 * (room.velocity + state.velocity());
    return outcome;
  }
  const bool starts = integrator.start && state.last_dt != dt;
  const auto numbers =
      scaled(starts ? *integrator.start : std::get<ImplicitStep<>>(integrator.step), integrator.history, dt);
  const auto outcome = solve_implicit(model, state, load, part, numbers, workspace.options, room);
  if (outcome.status != Status::done) return outcome;
  const bool once = outcome.evaluations == 1 && may_linearise(model, load, numbers);
  const bool evaluated_at_end = numbers.rule == ForceRule::at_point && numbers.point == 1 && !once;
  if (!is_cubic(model.force) && !evaluated_at_end) {
    room.point = state.z() + room.delta;
    if (!admits<Scalar>(model.force, room.point, room.at_point))
      return {.status = Status::not_finite, .iterations = outcome.iterations, .evaluations = outcome.evaluations};
  }
  if (derivative && once) chain_linearised(model, state, load, part, numbers, room, *derivative);
  else if (derivative) chain_implicit(model, state, load, part, numbers, room, *derivative);
  advance(numbers, room.delta, dt, room.next, state);
  return outcome;
}

template <class Scalar>
bool all_finite(const State<Scalar>& state) {
  return state.history.allFinite() &&
         (!state.frame || (state.frame->origin.allFinite() && state.frame->rotation.coeffs().allFinite()));
}

/// Of the forces that were evaluated last.
template <class Scalar>
double evaluated_energy(const Integrator& integrator, const NewtonRoom<Scalar>& room) {
  const auto* implicit = std::get_if<ImplicitStep<>>(&integrator.step);
  const bool mean = implicit && implicit->rule == ForceRule::mean_of_step;
  return static_cast<double>(mean ? room.mean.at_point.energy : room.at_point.energy);
}

template <class Scalar>
Outcome step_in_parts(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load, Scalar dt,
                      Workspace<Scalar>& workspace, StepDerivative<Scalar>* derivative) {
  auto& room = std::get<NewtonRoom<Scalar>>(workspace.room);
  refuse_unstable(workspace.integrator, room.highest_frequency, double(dt));
  const auto narrowest = std::ldexp(Scalar(1), -workspace.options.halvings);
  Outcome outcome{.error = 0};
  room.before = state;
  StepPart<Scalar> part;
  auto& [at, width] = part;
  while (at < 1) {
    room.begin = (1 - at) * load.begin + at * load.end;
    room.end = (1 - at - width) * load.begin + (at + width) * load.end;
    const auto tried = attempt(model, state, load, part, width * dt, workspace, derivative);
    outcome.iterations += tried.iterations;
    outcome.evaluations += tried.evaluations;
    outcome.status = all_finite(state) ? tried.status : Status::not_finite;
    if (outcome.status == Status::done) {
      room.residual.setZero();
      add_damping<Scalar>(model, 1, room.delta, room.residual);
      outcome.work += static_cast<double>((room.begin + room.end).dot(room.delta)) / 2;
      if (load.position) outcome.work += static_cast<double>(room.position_force.dot(room.delta));
      outcome.dissipated += static_cast<double>(room.residual.dot(room.delta) / (width * dt));
      outcome.error += tried.error;
      outcome.elastic = std::max(outcome.elastic, evaluated_energy(workspace.integrator, room));
      at += width;
      if (width < 1 && std::fmod(at, 2 * width) == 0) width *= 2;
      continue;
    }
    ++outcome.rejected;
    width /= 2;
    if (tried.status != Status::done && width >= narrowest) continue;
    state = room.before;
    return outcome;
  }
  return outcome;
}

template <class Scalar>
Outcome take_step(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load, Scalar dt,
                  Workspace<Scalar>& workspace, StepDerivative<Scalar>* derivative) {
  if (is_carried(model) != state.frame.has_value())
    throw std::logic_error("a frame belongs to the state of a carried body, and to no other");
  if (load.position && workspace.loads == Loads::of_time)
    throw std::logic_error("a workspace made for loads of time was given a force of position");
  if (auto* tables = std::get_if<OscillatorTables<Scalar>>(&workspace.room))
    return step_from_tables(model, state, load, dt, workspace.integrator, *tables, derivative);
  return step_in_parts(model, state, load, dt, workspace, derivative);
}

}  // namespace

template <class Scalar>
Workspace<Scalar> make_workspace(const Model<Scalar>& model, const Integrator& integrator,
                                 std::type_identity_t<Scalar> dt, const NewtonOptions<Scalar>& options, Loads loads) {
  if (!(dt > 0)) throw InputError("a step of " + shown(dt) + " s is not positive");
  if (is_oscillators(model) && loads == Loads::of_time)
    return {integrator, options, loads, make_tables(model, integrator, dt)};
  if (std::holds_alternative<OscillatorRule>(integrator.step))
    throw InputError("the integrator '" + std::string(integrator.name) +
                     "' is for linear models under loads that depend on time alone");
  auto room = make_room(model, integrator, loads);
  refuse_unstable(integrator, room.highest_frequency, double(dt));
  return {integrator, options, loads, std::move(room)};
}

template <class Scalar>
Vector<Scalar> balanced_acceleration(const Model<Scalar>& model, VectorRef<Scalar> z, VectorRef<Scalar> velocity,
                                     VectorRef<Scalar> load, Evaluation<Scalar>& room) {
  evaluate<Scalar>(model.force, z, room);
  Vector<Scalar> force = load;
  add_damping<Scalar>(model, -1, velocity, force);
  force -= room.force;
  if (!std::holds_alternative<UnitInertia>(model.inertia)) {
    auto inertia = make_inertia_at<Scalar>(model.size());
    const Vector<Scalar> none = Vector<Scalar>::Zero(model.size());
    evaluate<Scalar>(model.inertia, z, velocity, none, inertia);
    force -= inertia.force;
    auto factors = make_factors<Scalar>(model.size());
    factor(inertia.mass, factors);
    solve_in_place(factors, force);
  }
  return force;
}

template <class Scalar>
State<Scalar> make_state(const Model<Scalar>& model, const Integrator& integrator, VectorRef<Scalar> z,
                         VectorRef<Scalar> velocity, VectorRef<Scalar> load) {
  State<Scalar> state;
  state.history.setZero(model.size(), history_size(integrator.history));
  state.history.col(0) = z;
  state.history.col(1) = velocity;
  if (is_carried(model)) {
    state.history.col(0).template head<frame_coordinates>().setZero();
    state.frame.emplace();
  }
  if (integrator.history != History::acceleration) return state;
  auto room = make_evaluation(model.force);
  state.history.col(2) = balanced_acceleration<Scalar>(model, z, velocity, load, room);
  return state;
}

template <class Scalar>
Outcome step(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load,
             std::type_identity_t<Scalar> dt, Workspace<Scalar>& workspace) {
  return take_step<Scalar>(model, state, load, dt, workspace, nullptr);
}

template <class Scalar>
Outcome step(const Model<Scalar>& model, State<Scalar>& state, const StepLoad<Scalar>& load,
             std::type_identity_t<Scalar> dt, Workspace<Scalar>& workspace, StepDerivative<Scalar>& derivative) {
  auto chained = make_step_derivative(model, workspace.integrator);
  const auto outcome = take_step<Scalar>(model, state, load, dt, workspace, &chained);
  if (outcome.status == Status::done) derivative = std::move(chained);
  return outcome;
}

#define RITZ_INSTANCE(S)                                                                                               \
  template Workspace<S> make_workspace(const Model<S>&, const Integrator&, S, const NewtonOptions<S>&, Loads);         \
  template Vector<S> balanced_acceleration(const Model<S>&, VectorRef<S>, VectorRef<S>, VectorRef<S>, Evaluation<S>&); \
  template State<S> make_state(const Model<S>&, const Integrator&, VectorRef<S>, VectorRef<S>, VectorRef<S>);          \
  template Outcome step(const Model<S>&, State<S>&, const StepLoad<S>&, S, Workspace<S>&);                             \
  template Outcome step(const Model<S>&, State<S>&, const StepLoad<S>&, S, Workspace<S>&, StepDerivative<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
