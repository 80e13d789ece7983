#include "ritz/runtime/statics.hpp"

#include <algorithm>
#include <cmath>

#include "ritz/runtime/symmetric_eigen.hpp"

namespace ritz::runtime {
namespace {

/// What a balanced load may push a rigid mode by, of the largest |f_i|.
template <class Scalar>
constexpr Scalar rigid_push = Scalar(1e-8);

template <class Scalar>
double smallest_eigenvalue(const Matrix<Scalar>& matrix) {
  return eigenvalues(matrix.template cast<double>()).minCoeff();
}

/// Newton's method for f̃(trial) = load; done where it ends in a stable state.
template <class Scalar>
Outcome find_rest(const Model<Scalar>& model, StaticWorkspace<Scalar>& workspace) {
  constexpr Scalar rounding = 8 * std::numeric_limits<Scalar>::epsilon();
  auto& [options, softest, held, at, factors, trial, load, residual] = workspace;
  Outcome outcome{.status = Status::not_converged};
  for (bool last = false;;) {
    evaluate<Scalar>(model.force, trial, at);
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
/// this is a quadratic for a force that is a cubic polynomial, which three values tell; of others there are nine
/// samples.
template <class Scalar>
bool stays_stable(const Model<Scalar>& model, const Vector<Scalar>& z, StaticWorkspace<Scalar>& workspace) {
  auto& at = workspace.at;
  auto &load = workspace.load, &way = workspace.residual;
  way = workspace.trial - z;
  const auto stiffness_at = [&](Scalar s) {
    load = z + s * way;
    evaluate<Scalar>(model.force, load, at);
    load.noalias() = at.tangent * way;
    return way.dot(load);
  };
  if (way.squaredNorm() == 0) return true;
  if (!is_cubic(model.force)) {
    for (int eighth = 0; eighth <= 8; ++eighth)
      if (!(stiffness_at(Scalar(eighth) / 8) > 0)) return false;
    return true;
  }
  const Scalar begin = stiffness_at(0), middle = stiffness_at(Scalar(0.5)), end = stiffness_at(1);
  const Scalar curvature = 2 * (begin - 2 * middle + end), slope = end - begin - curvature;
  const Scalar lowest = curvature > 0 ? std::clamp(-slope / (2 * curvature), Scalar(0), Scalar(1)) : Scalar(0);
  return begin > 0 && end > 0 && begin + lowest * (slope + lowest * curvature) > 0;
}

constexpr double jump = 0.2;  ///< of z, which no narrow increment changes by more on a smooth path

/// Whether K̃ ceases to be positive definite within an increment of the load from z on. A path bends towards a limit
/// point as a parabola does: its tangent foretells half of the way.
template <class Scalar>
bool loses_stability(const Model<Scalar>& model, const Vector<Scalar>& z, const Vector<Scalar>& increment,
                     StaticWorkspace<Scalar>& workspace) {
  auto& [options, softest, held, at, factors, trial, load, ahead] = workspace;
  evaluate<Scalar>(model.force, z, at);
  factor(at.tangent, factors);
  if (!factors.definite) return true;
  ahead = increment;
  solve_in_place(factors, ahead);
  trial = z + std::min(Scalar(2), Scalar(jump) * z.norm() / ahead.norm()) * ahead;
  evaluate<Scalar>(model.force, trial, at);
  if (!std::isfinite(at.energy)) return false;  // a law ends there, not the stability
  factor(at.tangent, factors);
  return !factors.definite;
}

/// What ends a path: z is its last state, and `increment` the load that could not be added.
template <class Scalar>
void give_up(const Model<Scalar>& model, const Vector<Scalar>& z, const Vector<Scalar>& increment,
             StaticWorkspace<Scalar>& workspace, StaticOutcome& outcome) {
  outcome.failure = increment.allFinite() ? NoRest::not_converged : NoRest::not_finite;
  if (!increment.allFinite() || !loses_stability(model, z, increment, workspace)) return;
  evaluate<Scalar>(model.force, z, workspace.at);
  const double softest = smallest_eigenvalue(workspace.at.tangent);
  if (softest > workspace.softest_at_rest / 2) return;  // a limit point announces itself; a law may end at once
  outcome.failure = NoRest::limit_point;
  outcome.softest = softest;
}

/// z_i = f_i / λ_i.
template <class Scalar>
StaticOutcome solve_linear(const LinearForce<Scalar>& force, const VectorRef<Scalar>& load, Vector<Scalar>& z) {
  StaticOutcome outcome;
  if (!load.allFinite()) {
    outcome.failure = NoRest::not_finite;
    return outcome;
  }
  const Scalar scale = load.size() == 0 ? Scalar(0) : load.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < load.size(); ++i) {
    if (force.stiffness[i] == 0 && std::abs(load[i]) > rigid_push<Scalar> * scale) {
      outcome.failure = NoRest::free_body;
      outcome.pushed = i;
      outcome.reached = 0;
      return outcome;
    }
  }
  for (Eigen::Index i = 0; i < load.size(); ++i) z[i] = force.stiffness[i] > 0 ? load[i] / force.stiffness[i] : 0;
  return outcome;
}

}  // namespace

template <class Scalar>
StaticWorkspace<Scalar> make_static_workspace(const Model<Scalar>& model, const NewtonOptions<Scalar>& options) {
  const Vector<Scalar> none = Vector<Scalar>::Zero(model.size());
  StaticWorkspace<Scalar> workspace{.options = options, .trial = none, .load = none, .residual = none};
  if (std::holds_alternative<LinearForce<Scalar>>(model.force)) return workspace;
  const Matrix<Scalar> rest = stiffness_at_rest(model.force);
  workspace.softest_at_rest = smallest_eigenvalue(rest);
  workspace.held = workspace.softest_at_rest > rigid_stiffness * static_cast<double>(rest.diagonal().maxCoeff());
  workspace.at = make_evaluation(model.force);
  workspace.factors = make_factors<Scalar>(model.size());
  return workspace;
}

template <class Scalar>
StaticOutcome solve_static(const Model<Scalar>& model, const LoadPath<Scalar>& path, Vector<Scalar>& z,
                           StaticWorkspace<Scalar>& workspace) {
  if (const auto* linear = std::get_if<LinearForce<Scalar>>(&model.force)) return solve_linear(*linear, path.end, z);
  StaticOutcome outcome;
  outcome.reached = 0;
  double& at = outcome.reached;
  if (!workspace.held) {
    outcome.failure = NoRest::free_body;
    return outcome;
  }
  const double narrowest = std::ldexp(1.0, -workspace.options.halvings);
  double width = 1;  // fractions of the path, exact in binary
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
    if (width >= narrowest) continue;
    const Vector<Scalar> increment = Scalar(2 * width) * (path.end - path.begin);
    give_up(model, z, increment, workspace, outcome);
    return outcome;
  }
  return outcome;
}

#define RITZ_INSTANCE(S)                                                                       \
  template StaticWorkspace<S> make_static_workspace(const Model<S>&, const NewtonOptions<S>&); \
  template StaticOutcome solve_static(const Model<S>&, const LoadPath<S>&, Vector<S>&, StaticWorkspace<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
