// An integrator's numbers for a step of any length, and for a step of one oscillator.
#include <cmath>

#include "ritz/runtime/integrator.hpp"

namespace ritz::runtime {
namespace {

/// Column c of a history counts in z's units times s^−powers[c].
std::array<int, 4> powers(History history) { return {0, 1, history == History::acceleration ? 2 : 0, 1}; }

/// x Δtᵏ, with one rounding for each product.
template <class Scalar>
Scalar times(Scalar x, Scalar dt, int k) {
  const Scalar factor = std::abs(k) == 2 ? dt * dt : dt;
  if (k == 0) return x;
  return k > 0 ? x * factor : x / factor;
}

template <class Scalar, class Step>
void scale_history(const std::array<int, 4>& p, Scalar dt, Step& step) {
  for (int c = 0; c < 4; ++c)
    for (int j = 0; j < 4; ++j) step.history(c, j) = times<Scalar>(step.history(c, j), dt, p[j] - p[c]);
}

}  // namespace

template <class Scalar>
ImplicitStep<Scalar> scaled(const ImplicitStep<>& unit, History history, Scalar dt) {
  const auto p = powers(history);
  ImplicitStep<Scalar> step{.inertia = times(Scalar(unit.inertia), dt, -2),
                            .drag = times(Scalar(unit.drag), dt, -1),
                            .rule = unit.rule,
                            .point = Scalar(unit.point),
                            .acceleration = unit.acceleration.cast<Scalar>(),
                            .velocity = unit.velocity.cast<Scalar>(),
                            .begin = Scalar(unit.begin),
                            .end = Scalar(unit.end),
                            .history = unit.history.cast<Scalar>(),
                            .change = unit.change.cast<Scalar>(),
                            .guess = unit.guess.cast<Scalar>(),
                            .trust = Scalar(unit.trust),
                            .error = Scalar(unit.error)};
  for (int c = 0; c < 4; ++c) {
    step.guess[c] = times(step.guess[c], dt, p[c]);
    step.acceleration[c] = times(step.acceleration[c], dt, p[c] - 2);
    step.velocity[c] = times(step.velocity[c], dt, p[c] - 1);
    step.change[c] = times(step.change[c], dt, -p[c]);
  }
  scale_history(p, dt, step);
  return step;
}

template <class Scalar>
ExplicitStep<Scalar> scaled(const ExplicitStep<>& unit, History history, Scalar dt) {
  const auto p = powers(history);
  ExplicitStep<Scalar> step{.displacement = unit.displacement.cast<Scalar>(),
                            .velocity = unit.velocity.cast<Scalar>(),
                            .drag = times(Scalar(unit.drag), dt, 1),
                            .history = unit.history.cast<Scalar>(),
                            .change = unit.change.cast<Scalar>(),
                            .stable = Scalar(unit.stable)};
  for (int c = 0; c < 4; ++c) {
    step.displacement[c] = times(step.displacement[c], dt, p[c]);
    step.velocity[c] = times(step.velocity[c], dt, p[c] - 1);
    step.change[c] = times(step.change[c], dt, 2 - p[c]);
  }
  scale_history(p, dt, step);
  return step;
}

template ImplicitStep<double> scaled(const ImplicitStep<>&, History, double);
template ImplicitStep<float> scaled(const ImplicitStep<>&, History, float);
template ExplicitStep<double> scaled(const ExplicitStep<>&, History, double);
template ExplicitStep<float> scaled(const ExplicitStep<>&, History, float);

namespace {

// The coefficients are computed once, so they can afford the longest type there is.
using Real = long double;
using Column = Eigen::Matrix<Real, 4, 1>;

/// The unknown x of a step, pivot x = row y + begin f_n + end f_{n+1}, in units in which the step lasts 1.
struct Unknown {
  Real pivot;
  Column row;
  Real begin, end;
};

/// y := history y + change x, in seconds.
OscillatorStep eliminate(const Unknown& x, const Eigen::Matrix4d& history, const Eigen::Vector4d& change,
                         const std::array<int, 4>& p, Real dt) {
  const Column share = change.cast<Real>() / x.pivot;
  const Eigen::Matrix<Real, 4, 4> A = history.cast<Real>() + share * x.row.transpose();
  OscillatorStep step;
  for (int c = 0; c < 4; ++c) {
    for (int j = 0; j < 4; ++j) step.A(c, j) = static_cast<double>(times(A(c, j), dt, p[j] - p[c]));
    step.b[c] = static_cast<double>(times(share[c] * x.begin, dt, 2 - p[c]));
    step.c[c] = static_cast<double>(times(share[c] * x.end, dt, 2 - p[c]));
  }
  return step;
}

struct StepOf {
  History history;
  double stiffness, damping, dt;
  Real K = Real(stiffness) * dt * dt, C = Real(damping) * dt;

  OscillatorStep operator()(const ImplicitStep<>& step) const {
    Unknown delta{.pivot = step.inertia + C * step.drag + K * step.point,
                  .row = step.acceleration.cast<Real>() + C * step.velocity.cast<Real>(),
                  .begin = step.begin,
                  .end = step.end};
    delta.row[0] -= K;
    return eliminate(delta, step.history, step.change, powers(history), dt);
  }

  OscillatorStep operator()(const ExplicitStep<>& step) const {
    Unknown acceleration{.pivot = 1 + C * step.drag,
                         .row = -C * step.velocity.cast<Real>() - K * step.displacement.cast<Real>(),
                         .begin = 0,
                         .end = 1};
    acceleration.row[0] -= K;
    return eliminate(acceleration, step.history, step.change, powers(history), dt);
  }

  OscillatorStep operator()(OscillatorRule rule) const { return rule(stiffness, damping, dt); }
};

}  // namespace

OscillatorStep oscillator_step(const Integrator& integrator, StepKind kind, double stiffness, double damping,
                               double dt) {
  const StepOf step{integrator.history, stiffness, damping, dt};
  if (kind == StepKind::first && integrator.start) return step(*integrator.start);
  return std::visit(step, integrator.step);
}

}  // namespace ritz::runtime
