// What an integrator is: a set of coefficients. Every method here is linear in the history of a step, y = [z, z', ...],
// and in the unknown for which the step solves. A coefficient depends on the length of the step only by a power of that
// length, so that a method is given by its coefficients for a step of unit length. The same coefficients step an
// oscillator from a table, step a nonlinear model by Newton's method, and give the derivative of the step.
#pragma once
#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string_view>
#include <variant>

namespace ritz::runtime {

/// The largest number of columns of a history.
inline constexpr int max_history = 4;

/// The columns of a history y, r numbers each. The subscript n is the state that is reached.
enum class History : unsigned char {
  none,          ///< y = [z, z']
  acceleration,  ///< y = [z, z', z'']
  last_step      ///< y = [z, z', z_n − z_{n−1}, z'_{n−1}]
};

/// The number of columns of a history.
constexpr int history_size(History history) {
  switch (history) {
    case History::none: return 2;
    case History::acceleration: return 3;
    case History::last_step: return 4;
  }
  return 0;
}

/// Where along a step, with δ = z_{n+1} − z_n, a method evaluates the internal force.
enum class ForceRule : unsigned char {
  at_point,     ///< f̃(z_n + point δ)
  mean_of_step  ///< ∫₀¹ f̃(z_n + s δ) ds; then `point` is ½, the mean of s
};

/// An implicit method. The step solves for the change δ = z_{n+1} − z_n in
///
///   M (inertia δ − Σ_c acceleration_c y_c) + D (drag δ − Σ_c velocity_c y_c) + f̃ = begin f_n + end f_{n+1},
///
/// where the first bracket is the acceleration and the second the velocity at which the equation holds. The new history
/// is y_c := Σ_j history_cj y_j + change_c δ. Coefficients of columns that the history does not have are zero.
///
/// Newton's iteration starts at δ = 0. A linearly implicit method also has a guess δ* = Σ_c guess_c y_c and a `trust`
/// above 0: where the residual at δ* is at most `trust` times the sum of the norms of its terms (see NewtonOptions), δ
/// is the solution of the equation linearised at δ*, for one evaluation and one factorization. Elsewhere, and always
/// where forces depend on the position or the inertia varies, it iterates as others do.
template <class Scalar = double>
struct ImplicitStep {
  using Column = Eigen::Matrix<Scalar, 4, 1>;
  Scalar inertia = 0;  ///< 1/s²
  Scalar drag = 0;     ///< 1/s
  ForceRule rule = ForceRule::at_point;
  Scalar point = 1;  ///< where along the step f̃ is taken, 0 ... 1
  Column acceleration = Column::Zero();
  Column velocity = Column::Zero();
  Scalar begin = 0, end = 1;  ///< weights of the loads f_n and f_{n+1}
  Eigen::Matrix<Scalar, 4, 4> history = Eigen::Matrix<Scalar, 4, 4>::Zero();
  Column change = Column::Zero();
  Column guess = Column::Zero();
  Scalar trust = 0;
  Scalar error =
      std::numeric_limits<Scalar>::quiet_NaN();  ///< the local error of z is error ‖δ − δ*‖; NaN: no estimate
};

/// An explicit method. The change δ = Σ_c displacement_c y_c is known, and the step solves for the acceleration a at
/// its end in
///
///   M a + D (drag a + Σ_c velocity_c y_c) + f̃(z_n + δ) = f_{n+1}.
///
/// The new history is y_c := Σ_j history_cj y_j + change_c a.
template <class Scalar = double>
struct ExplicitStep {
  using Column = Eigen::Matrix<Scalar, 4, 1>;
  Column displacement = Column::Zero();
  Column velocity = Column::Zero();
  Scalar drag = 0;  ///< s
  Eigen::Matrix<Scalar, 4, 4> history = Eigen::Matrix<Scalar, 4, 4>::Zero();
  Column change = Column::Zero();
  Scalar stable = 0;  ///< the largest ωΔt of a stable step, where ω is the highest frequency
};

/// One step of one oscillator: y_{n+1} = A y_n + b f_n + c f_{n+1}.
struct OscillatorStep {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  Eigen::Vector4d c = Eigen::Vector4d::Zero();
};

/// Returns the step of the oscillator z'' + damping z' + stiffness z = f over `dt` seconds (damping in 1/s, stiffness
/// in 1/s²), for a method that applies to oscillators alone.
using OscillatorRule = OscillatorStep (*)(double stiffness, double damping, double dt);

/// An integrator: its name, its history, and its coefficients for a step of 1 s.
struct Integrator {
  std::string_view name;
  History history;
  std::variant<ImplicitStep<>, ExplicitStep<>, OscillatorRule> step;
  std::optional<ImplicitStep<>> start = {};  ///< if present, for the first step and the first one of another length
};

/// The coefficients for a step of `dt` seconds, from those for a step of 1 s.
template <class Scalar>
ImplicitStep<Scalar> scaled(const ImplicitStep<>& step, History history, Scalar dt);
template <class Scalar>
ExplicitStep<Scalar> scaled(const ExplicitStep<>& step, History history, Scalar dt);

/// The exact solution for a force that is linear in time over the step, at any ωΔt and any damping, including
/// rigid modes (λ = 0). Applies to oscillators alone.
Integrator exact();
/// The implicit Euler method, first order. On linear models it never gains energy; it damps every frequency.
Integrator implicit_euler();
/// Newmark's method with average acceleration, β = ¼, γ = ½; second order. It conserves the energy of an undamped
/// linear model; on nonlinear models the energy is not bounded.
Integrator newmark();
/// The generalised-α method of Chung and Hulbert [CH93] with ρ∞ = 0.8; second order. As ωΔt → ∞ a step multiplies the
/// amplitude by 0.8. The internal force is evaluated at the mixed point α_f z_n + (1 − α_f) z_{n+1}.
Integrator generalized_alpha();
/// The linearly implicit form of that method, second order: where the guess δ* = Δt z' + ½ Δt² z'' is good, its
/// equation is linearised there and solved once, as [BJ05] take one Newton iteration a step; where it is not, as at a
/// sudden load or a step too long for the motion, it is solved as generalized_alpha solves it. As δ − δ* is O(Δt³),
/// linearising changes δ by O(Δt⁸). The local error is estimated as by [ZX91], from the change of z'' over the step,
/// which is in proportion to δ − δ*.
Integrator linearly_implicit();
/// Backward differences of second order. The first step, and every first step of another length, is one of implicit
/// Euler.
Integrator bdf2();
/// The central difference method: explicit, second order. When ω_max Δt > 2, with the highest frequency ω_max at rest,
/// making a workspace and stepping throw an InputError that names the longest stable step.
Integrator central_difference();
/// The average vector field method [QM08], second order. It uses the mean of f̃ over the straight line from z_n to
/// z_{n+1}. Without damping the energy changes by the work of the loads alone, at any step length. For a linear force
/// it is the implicit midpoint rule.
Integrator avf();

/// `first`: the first step, or the first one of another length; for it an integrator may have coefficients of its own.
enum class StepKind : unsigned char { first, later };

/// The step of the oscillator z'' + damping z' + stiffness z = f over `dt` seconds (damping in 1/s, stiffness in 1/s²)
/// by any integrator; for StepKind::first by its `start`, where it has one. Computed in extended precision.
OscillatorStep oscillator_step(const Integrator& integrator, StepKind kind, double stiffness, double damping,
                               double dt);

/// Throws InputError when a step of `dt` seconds of an explicit integrator is unstable for the frequency ω, rad/s.
void refuse_unstable(const Integrator& integrator, double omega, double dt);

}  // namespace ritz::runtime
