#include "attempt.hpp"

namespace ritz::runtime {
namespace {

using Eigen::Index;

/// matrix := (the factored matrix)⁻¹ matrix.
template <class Scalar>
void solve_columns(const Factors<Scalar>& factors, Matrix<Scalar>& matrix) {
  Vector<Scalar> column(matrix.rows());
  for (Index j = 0; j < matrix.cols(); ++j) {
    column = matrix.col(j);
    solve_in_place(factors, column);
    matrix.col(j) = column;
  }
}

/// The unknown's derivative: by the history, r x h r, and by the loads of the part, r x r.
template <class Scalar>
struct UnknownDerivative {
  Matrix<Scalar> state, begin, end;
};

/// The first six coordinates of z_{n+1}, which are small motions of the moved frame by its own axes: of the rows that
/// z_n + δ has, `change` being δ's first six.
template <class Scalar>
void follow_frame(const FrameChange<Scalar>& change, Matrix<Scalar>& state, Matrix<Scalar>& begin,
                  Matrix<Scalar>& end) {
  const auto [by_frame, by_change] = moved_derivative<Scalar>(change);
  Matrix<Scalar> of_change = state.topRows(frame_coordinates);
  of_change.leftCols(frame_coordinates).diagonal().array() -= 1;
  state.topRows(frame_coordinates) = by_change * of_change;
  state.template topLeftCorner<frame_coordinates, frame_coordinates>() += by_frame;
  for (auto* load : {&begin, &end}) {
    const Matrix<Scalar> rows = load->topRows(frame_coordinates);
    load->topRows(frame_coordinates) = by_change * rows;
  }
}

/// dy_c = Σ_j history_cj dy_j + change_c dx, after the parts before. `frame`: δ, where it moves a frame.
template <class Scalar, class Numbers>
void chain(const UnknownDerivative<Scalar>& unknown, const Numbers& numbers, const StepPart<Scalar>& part,
           const Vector<Scalar>* frame, StepDerivative<Scalar>& derivative) {
  const Index r = unknown.state.rows(), width = unknown.state.cols() / r;
  Matrix<Scalar> state(width * r, width * r), begin(width * r, r), end(width * r, r);
  for (Index c = 0; c < width; ++c) {
    state.middleRows(c * r, r) = numbers.change[c] * unknown.state;
    begin.middleRows(c * r, r) = numbers.change[c] * unknown.begin;
    end.middleRows(c * r, r) = numbers.change[c] * unknown.end;
    for (Index j = 0; j < width; ++j) state.block(c * r, j * r, r, r).diagonal().array() += numbers.history(c, j);
  }
  if (frame) follow_frame<Scalar>(frame->template head<frame_coordinates>(), state, begin, end);
  const auto [at, wide] = part;
  derivative.state = state * derivative.state;
  derivative.begin = state * derivative.begin + (1 - at) * begin + (1 - at - wide) * end;
  derivative.end = state * derivative.end + at * begin + (at + wide) * end;
}

/// The derivative of all forces by z_n: internal less those of position, K̃ or its mean.
template <class Scalar>
Matrix<Scalar> tangent_at_begin(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                                const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers,
                                NewtonRoom<Scalar>& room) {
  Matrix<Scalar> tangent = Matrix<Scalar>::Zero(model.size(), model.size());
  each_force_point(model, numbers, [&](Scalar s, Scalar weight) {
    room.point = state.z() + s * room.delta;
    evaluate<Scalar>(model.force, room.point, room.at_point);
    tangent += weight * room.at_point.tangent;
    if (!load.position) return;
    evaluate_at(*load.position, state, room.point, part.at + s * part.width, By::beginning, room.position_sum,
                room.position_tangent);
    tangent -= weight * room.position_tangent;
  });
  return tangent;
}

template <class Scalar>
Matrix<Scalar> mass_of(const Model<Scalar>& model, const NewtonRoom<Scalar>& room) {
  Matrix<Scalar> mass = Matrix<Scalar>::Zero(model.size(), model.size());
  add_mass(model.inertia, Scalar(1), room.inertia, mass);
  return mass;
}

/// D, and what a varying inertia adds to it.
template <class Scalar>
Matrix<Scalar> damping_of(const Model<Scalar>& model, const NewtonRoom<Scalar>& room) {
  Matrix<Scalar> damping = Matrix<Scalar>::Zero(model.size(), model.size());
  add_damping<Scalar>(model, 1, damping);
  if (std::holds_alternative<VaryingInertia<Scalar>>(model.inertia)) damping += room.inertia.by_velocity;
  return damping;
}

/// The derivative of δ where it solves the equation of the step, linearised at room.delta.
template <class Scalar>
UnknownDerivative<Scalar> differentiate_implicit(const Model<Scalar>& model, const State<Scalar>& state,
                                                 const StepLoad<Scalar>& load, const StepPart<Scalar>& part,
                                                 const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room) {
  const Index r = model.size();
  evaluate_forces(model, state, load, part, numbers, room);
  evaluate_inertia(model, state, numbers, room);
  factor_jacobian(model, load, numbers, room);
  const Matrix<Scalar> mass = mass_of(model, room), damping = damping_of(model, room);
  UnknownDerivative<Scalar> delta{.state = Matrix<Scalar>(r, r * state.history.cols()),
                                  .begin = numbers.begin * Matrix<Scalar>::Identity(r, r),
                                  .end = numbers.end * Matrix<Scalar>::Identity(r, r)};
  for (Index c = 0; c < state.history.cols(); ++c)
    delta.state.middleCols(c * r, r) = numbers.acceleration[c] * mass + numbers.velocity[c] * damping;
  const Vector<Scalar> position_force = room.position_force;
  delta.state.leftCols(r) -= tangent_at_begin(model, state, load, part, numbers, room);
  if (std::holds_alternative<VaryingInertia<Scalar>>(model.inertia))
    delta.state.leftCols(r) -= room.inertia.by_position;
  room.position_force = position_force;
  for (auto* matrix : {&delta.state, &delta.begin, &delta.end}) solve_columns(room.factors, *matrix);
  return delta;
}

/// The matrix d(K̃(q) w)/dq, r x r: a difference of tangents, which is exact as they are quadratic in q.
template <class Scalar>
Matrix<Scalar> second_derivative(const Model<Scalar>& model, const Vector<Scalar>& q, const Vector<Scalar>& w,
                                 NewtonRoom<Scalar>& room) {
  const Vector<Scalar> ahead = q + w, behind = q - w;
  evaluate<Scalar>(model.force, ahead, room.at_point);
  const Matrix<Scalar> tangent = room.at_point.tangent;
  evaluate<Scalar>(model.force, behind, room.at_point);
  return (tangent - room.at_point.tangent) / 2;
}

}  // namespace

template <class Scalar>
StepDerivative<Scalar> make_step_derivative(const Model<Scalar>& model, const Integrator& integrator) {
  const Index r = model.size(), size = history_size(integrator.history) * r;
  return {Matrix<Scalar>::Identity(size, size), Matrix<Scalar>::Zero(size, r), Matrix<Scalar>::Zero(size, r)};
}

template <class Scalar>
void chain_implicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                    const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room,
                    StepDerivative<Scalar>& derivative) {
  const auto delta = differentiate_implicit(model, state, load, part, numbers, room);
  chain(delta, numbers, part, state.frame ? &room.delta : nullptr, derivative);
}

template <class Scalar>
void chain_linearised(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                      const StepPart<Scalar>& part, const ImplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room,
                      StepDerivative<Scalar>& derivative) {
  const Index r = model.size();
  const Vector<Scalar> solution = room.delta;
  combine(state.history, numbers.guess, room.delta);
  auto delta = differentiate_implicit(model, state, load, part, numbers, room);
  auto bent = second_derivative<Scalar>(model, state.z() + numbers.point * room.delta, room.delta - solution, room);
  bent *= numbers.point;
  solve_columns(room.factors, bent);
  delta.state.leftCols(r) += bent;
  for (Index c = 0; c < state.history.cols(); ++c)
    delta.state.middleCols(c * r, r) += numbers.point * numbers.guess[c] * bent;
  room.delta = solution;
  chain(delta, numbers, part, state.frame ? &room.delta : nullptr, derivative);
}

template <class Scalar>
void chain_explicit(const Model<Scalar>& model, const State<Scalar>& state, const StepLoad<Scalar>& load,
                    const StepPart<Scalar>& part, const ExplicitStep<Scalar>& numbers, NewtonRoom<Scalar>& room,
                    StepDerivative<Scalar>& derivative) {
  const Index r = model.size(), width = derivative.state.rows() / r;
  Matrix<Scalar> by_change = room.at_point.tangent;
  if (std::holds_alternative<VaryingInertia<Scalar>>(model.inertia)) {
    const Vector<Scalar> velocity = room.velocity + numbers.drag * room.acceleration;
    evaluate<Scalar>(model.inertia, room.point, velocity, room.acceleration, room.inertia);
    by_change += room.inertia.by_position;
  }
  Matrix<Scalar> by_beginning = by_change;
  if (load.position) {
    by_change -= room.position_tangent;
    evaluate_at(*load.position, state, room.point, part.at + part.width, By::beginning, room.position_sum,
                room.position_tangent);
    by_beginning -= room.position_tangent;
  }
  const Matrix<Scalar> damping = damping_of(model, room);
  room.jacobian = mass_of(model, room) + numbers.drag * damping;
  factor_unsymmetric(room.jacobian, room.factors);
  room.factored_dt = 0;
  UnknownDerivative<Scalar> acceleration{.state = Matrix<Scalar>(r, r * width),
                                         .begin = Matrix<Scalar>::Zero(r, r),
                                         .end = Matrix<Scalar>::Identity(r, r)};
  for (Index c = 0; c < width; ++c) {
    acceleration.state.middleCols(c * r, r) = -numbers.displacement[c] * by_change - numbers.velocity[c] * damping;
    if (c == 0) acceleration.state.leftCols(r) -= by_beginning;
  }
  for (auto* matrix : {&acceleration.state, &acceleration.end}) solve_columns(room.factors, *matrix);
  chain(acceleration, numbers, part, state.frame ? &room.delta : nullptr, derivative);
}

#define RITZ_INSTANCE(S)                                                                                   \
  template StepDerivative<S> make_step_derivative(const Model<S>&, const Integrator&);                     \
  template void chain_implicit(const Model<S>&, const State<S>&, const StepLoad<S>&, const StepPart<S>&,   \
                               const ImplicitStep<S>&, NewtonRoom<S>&, StepDerivative<S>&);                \
  template void chain_linearised(const Model<S>&, const State<S>&, const StepLoad<S>&, const StepPart<S>&, \
                                 const ImplicitStep<S>&, NewtonRoom<S>&, StepDerivative<S>&);              \
  template void chain_explicit(const Model<S>&, const State<S>&, const StepLoad<S>&, const StepPart<S>&,   \
                               const ExplicitStep<S>&, NewtonRoom<S>&, StepDerivative<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
