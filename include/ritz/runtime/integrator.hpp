// What an integrator is: numbers. Every method here is linear in the history of a step, y = [z, z', ...], and in the
// unknown that the step solves for, with factors that depend on the step's length by a power alone: an integrator is
// its factors for a step of unit length. The same numbers step an oscillator from a table, step a nonlinear model by
// Newton's method, and give the derivative of the step.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <variant>

namespace ritz::runtime {

inline constexpr int max_history = 4;

/// What the columns of a history are, after z and z'.
enum class History : unsigned char {
  none,          ///< y = [z, z']
  acceleration,  ///< y = [z, z', z'']
  last_step      ///< y = [z, z', the last change z_n − z_{n−1}, z' of the step before]
};

constexpr int history_size(History history) {
  switch (history) {
    case History::none: return 2;
    case History::acceleration: return 3;
    case History::last_step: return 4;
  }
  return 0;
}

/// Where along its step a method takes the internal force.
enum class ForceRule : unsigned char {
  at_point,     ///< f̃(z_n + point δ)
  mean_of_step  ///< ∫₀¹ f̃(z_n + s δ) ds, whose mean s is `point` = ½
};

/// An implicit method. The step solves for the change δ = z_{n+1} − z_n,
///
///   M (inertia δ − Σ_c acceleration_c y_c) + D (drag δ − Σ_c velocity_c y_c) + f̃ = begin f_n + end f_{n+1},
///
/// the two brackets being the acceleration and the velocity that it weighs f̃ against. The new history is
/// y_c := Σ_j history_cj y_j + change_c δ. Rows past the method's history are zero.
template <class Scalar = double>
struct ImplicitStep {
  using Column = Eigen::Matrix<Scalar, 4, 1>;
  Scalar inertia = 0;  ///< 1/s²
  Scalar drag = 0;     ///< 1/s
  ForceRule rule = ForceRule::at_point;
  Scalar point = 1;  ///< 0 ... 1
  Column acceleration = Column::Zero();
  Column velocity = Column::Zero();
  Scalar begin = 0, end = 1;
  Eigen::Matrix<Scalar, 4, 4> history = Eigen::Matrix<Scalar, 4, 4>::Zero();
  Column change = Column::Zero();
};

/// An explicit method. The change is known, δ = Σ_c displacement_c y_c, and the step solves for the acceleration a at
/// its end,
///
///   M a + D (drag a + Σ_c velocity_c y_c) + f̃(z_n + δ) = f_{n+1};
///
/// the new history is y_c := Σ_j history_cj y_j + change_c a. It is stable up to ωΔt = `stable`, where ω is the highest
/// frequency.
template <class Scalar = double>
struct ExplicitStep {
  using Column = Eigen::Matrix<Scalar, 4, 1>;
  Column displacement = Column::Zero();
  Column velocity = Column::Zero();
  Scalar drag = 0;  ///< s
  Eigen::Matrix<Scalar, 4, 4> history = Eigen::Matrix<Scalar, 4, 4>::Zero();
  Column change = Column::Zero();
  Scalar stable = 0;
};

/// y_{n+1} = A y_n + b f_n + c f_{n+1}: a step of one oscillator.
struct OscillatorStep {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  Eigen::Vector4d c = Eigen::Vector4d::Zero();
};

/// The step of the oscillator z'' + damping z' + stiffness z = f over `dt` seconds, of a method that is for oscillators
/// alone.
using OscillatorRule = OscillatorStep (*)(double stiffness, double damping, double dt);

/// The numbers are those of a step of 1 s.
struct Integrator {
  std::string_view name;
  History history;
  std::variant<ImplicitStep<>, ExplicitStep<>, OscillatorRule> step;
  std::optional<ImplicitStep<>> start = {};  ///< the first step, and the first of another length, where it is another
};

/// The numbers of a step of `dt` seconds from those of 1 s.
template <class Scalar>
ImplicitStep<Scalar> scaled(const ImplicitStep<>& step, History history, Scalar dt);
template <class Scalar>
ExplicitStep<Scalar> scaled(const ExplicitStep<>& step, History history, Scalar dt);

/// The solution itself, for a force that is linear in time over the step; any ωΔt, any damping, λ = 0 included. For
/// oscillators alone.
Integrator exact();
/// Backward differences of first order. First order; on linear models never gains energy; damps every frequency.
Integrator implicit_euler();
/// Average acceleration, β = ¼, γ = ½: second order. Keeps the energy of an undamped linear model; on nonlinear ones
/// the energy is not bounded.
Integrator newmark();
/// Chung and Hulbert's method [CH93] with ρ∞ = 0.8: second order, damps ωΔt → ∞ by 0.8 a step. The internal force is
/// taken at the mixed point α_f z_n + (1 − α_f) z_{n+1}.
Integrator generalized_alpha();
/// Backward differences of second order; its first step, and the first of another length, is one of implicit Euler.
Integrator bdf2();
/// Explicit, second order. A step with ω_max Δt > 2 at rest is refused with an InputError naming the longest.
Integrator central_difference();
/// The average vector field [QM08]: z' and the mean of f̃ over the straight step: second order; undamped, the energy
/// changes by the loads' work alone, at any length of step. For a linear force it is the implicit midpoint rule.
Integrator avf();

enum class StepKind : unsigned char { first, later };

/// The step of one oscillator by any integrator, by its starting rule where `kind` says so. Computed in extended
/// precision.
OscillatorStep oscillator_step(const Integrator& integrator, StepKind kind, double stiffness, double damping,
                               double dt);

}  // namespace ritz::runtime
