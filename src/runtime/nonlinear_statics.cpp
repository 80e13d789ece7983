#include "ritz/runtime/nonlinear_statics.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "eigenvalues.hpp"
#include "rigid_stiffness.hpp"
#include "ritz/base/error.hpp"

namespace ritz::runtime {
namespace {

template <class Scalar>
double smallest_eigenvalue(const Matrix<Scalar>& matrix) {
  return eigenvalues(matrix.template cast<double>()).minCoeff();
}

/// Newton's method for f̃(trial) = load; done where it ends in a stable state.
template <class Scalar>
NonlinearOutcome find_rest(const NonlinearModel<Scalar>& model, StaticWorkspace<Scalar>& workspace) {
  constexpr Scalar rounding = 8 * std::numeric_limits<Scalar>::epsilon();
  auto& [options, at, factors, trial, load, residual] = workspace;
  NonlinearOutcome outcome{.status = Status::not_converged};
  for (bool last = false;;) {
    evaluate<Scalar>(model.forces, trial, at);
    ++outcome.evaluations;
    residual = at.force - load;
    const Scalar size = residual.norm();
    if (!std::isfinite(size)) {
      outcome.status = Status::not_finite;
      return outcome;
    }
    factor(at.tangent, factors);
    if (!factors.definite) return outcome;
    if (last || size <= options.tolerance * load.norm()) break;
    if (outcome.iterations == options.iterations) return outcome;
    solve_in_place(factors, residual);
    trial -= residual;
    ++outcome.iterations;
    last = residual.norm() <= rounding * trial.norm();
  }
  solve_in_place(factors, residual);  // costs next to nothing and makes a small residual tiny
  trial -= residual;
  outcome.status = Status::done;
  return outcome;
}

/// Whether dᵀK̃d > 0 all along the straight way d from z to the trial, which else jumped to another branch. Along it
/// this is a quadratic, which three values tell.
template <class Scalar>
bool stays_stable(const NonlinearModel<Scalar>& model, const Vector<Scalar>& z, StaticWorkspace<Scalar>& workspace) {
  auto& at = workspace.at;
  auto &load = workspace.load, &way = workspace.residual;
  way = workspace.trial - z;
  const auto stiffness_at = [&](Scalar s) {
    load = z + s * way;
    evaluate<Scalar>(model.forces, load, at);
    load.noalias() = at.tangent * way;
    return way.dot(load);
  };
  if (way.squaredNorm() == 0) return true;
  const Scalar begin = stiffness_at(0), middle = stiffness_at(Scalar(0.5)), end = stiffness_at(1);
  const Scalar curvature = 2 * (begin - 2 * middle + end), slope = end - begin - curvature;
  const Scalar lowest = curvature > 0 ? std::clamp(-slope / (2 * curvature), Scalar(0), Scalar(1)) : Scalar(0);
  return begin > 0 && end > 0 && begin + lowest * (slope + lowest * curvature) > 0;
}

constexpr double jump = 0.2;  ///< of z, which no narrow increment changes by more on a smooth path

/// Whether K̃ ceases to be positive definite within an increment of the load from z on. A path bends towards a limit
/// point as a parabola does: its tangent foretells half of the way.
template <class Scalar>
bool loses_stability(const NonlinearModel<Scalar>& model, const Vector<Scalar>& z, const Vector<Scalar>& increment,
                     StaticWorkspace<Scalar>& workspace) {
  auto& [options, at, factors, trial, load, ahead] = workspace;
  evaluate<Scalar>(model.forces, z, at);
  factor(at.tangent, factors);
  if (!factors.definite) return true;
  ahead = increment;
  solve_in_place(factors, ahead);
  trial = z + std::min(Scalar(2), Scalar(jump) * z.norm() / ahead.norm()) * ahead;
  evaluate<Scalar>(model.forces, trial, at);
  factor(at.tangent, factors);
  return !factors.definite;
}

template <class Scalar>
[[noreturn]] void give_up(const NonlinearModel<Scalar>& model, const Vector<Scalar>& z, double reached,
                          const Vector<Scalar>& increment, StaticWorkspace<Scalar>& workspace) {
  std::ostringstream text;
  text << "statics reached load fraction " << reached << " and no further: ";
  if (loses_stability(model, z, increment, workspace)) {
    evaluate<Scalar>(model.forces, z, workspace.at);
    text << "a limit point, where the smallest eigenvalue of the tangent stiffness goes to zero ("
         << smallest_eigenvalue(workspace.at.tangent) << " 1/s², at rest " << smallest_eigenvalue(model.forces.linear)
         << "); the body snaps or buckles there: follow it with [time] and damping";
  } else {
    text << "Newton's method does not converge; use more load steps, or [time] with damping";
  }
  throw NumericalError(text.str());
}

}  // namespace

template <class Scalar>
StaticWorkspace<Scalar> make_static_workspace(const NonlinearModel<Scalar>& model,
                                              const NewtonOptions<Scalar>& options) {
  const Matrix<Scalar> rest = model.forces.linear;
  if (!(smallest_eigenvalue(rest) > rigid_stiffness * static_cast<double>(rest.diagonal().maxCoeff())))
    throw InputError(
        "the body is free: a load sets it moving, so it has no state of rest; fix the body when reducing it, or use "
        "[time]");
  const Vector<Scalar> none = Vector<Scalar>::Zero(model.size());
  return {.options = options,
          .at = make_evaluation(model.forces),
          .factors = make_factors<Scalar>(model.size()),
          .trial = none,
          .load = none,
          .residual = none};
}

template <class Scalar>
NonlinearOutcome solve_static(const NonlinearModel<Scalar>& model, const LoadPath<Scalar>& path, Vector<Scalar>& z,
                              StaticWorkspace<Scalar>& workspace) {
  const double narrowest = std::ldexp(1.0, -workspace.options.halvings);
  NonlinearOutcome outcome;
  double at = 0, width = 1;  // fractions of the path, exact in binary
  while (at < 1) {
    workspace.load = Scalar(1 - at - width) * path.begin + Scalar(at + width) * path.end;
    workspace.trial = z;
    const auto part = find_rest(model, workspace);
    outcome.iterations += part.iterations;
    outcome.evaluations += part.evaluations;
    if (part.status == Status::done && stays_stable(model, z, workspace)) {
      z = workspace.trial;
      at += width;
      if (width < 1 && std::fmod(at, 2 * width) == 0) width *= 2;
      continue;
    }
    ++outcome.rejected;
    width /= 2;
    if (width < narrowest) {
      const Vector<Scalar> increment = Scalar(2 * width) * (path.end - path.begin);
      give_up(model, z, path.from + at * (path.to - path.from), increment, workspace);
    }
  }
  return outcome;
}

template StaticWorkspace<double> make_static_workspace(const NonlinearModel<double>&, const NewtonOptions<double>&);
template StaticWorkspace<float> make_static_workspace(const NonlinearModel<float>&, const NewtonOptions<float>&);
template NonlinearOutcome solve_static(const NonlinearModel<double>&, const LoadPath<double>&, Vector<double>&,
                                       StaticWorkspace<double>&);
template NonlinearOutcome solve_static(const NonlinearModel<float>&, const LoadPath<float>&, Vector<float>&,
                                       StaticWorkspace<float>&);

}  // namespace ritz::runtime
