#include "ritz/stages/full_statics.hpp"

#include <algorithm>
#include <cmath>

#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/stages/canonical.hpp"
#include "ritz/stages/rigid_modes.hpp"

namespace ritz::stages {
namespace {

constexpr int most_halvings = 10;  ///< of one increment: the load fraction of a limit point is known to 1/1024 of it
constexpr double jump = .2;        ///< a change of u, relative to u, that no such increment makes on a smooth path
constexpr std::uint64_t probe_stream = 4000;

void refuse_loose(const FullModel& model) {
  const auto motions = rigid_motions(model.problem.mesh, model.problem.dofs).cols();
  if (motions > 0)
    throw InputError("the supports leave the body " + std::to_string(motions) + " rigid motions",
                     Reason::rigid_motions);
}

class Loading {
 public:
  Loading(FullModel& model, const StaticOptions& options, const LoadAt& load)
      : model_(model), options_(options), load_(load) {}

  /// From `state` to the fraction `to`.
  void advance(StaticState& state, double to, int depth) {
    if (solve(state, to, depth)) return;
    if (depth == most_halvings) give_up(state, to);
    ++report.halvings;
    advance(state, (state.fraction + to) / 2, depth + 1);
    advance(state, to, depth + 1);
  }

  StaticReport report;

 private:
  bool solve(StaticState& state, double to, int depth) {
    const algebra::Tall F = load_(to);
    algebra::Tall u = state.u;
    const algebra::Equations equations{[&](const algebra::Tall& x, algebra::Tall& r) {
                                         auto [energy, force] = energy_and_force(model_, x);
                                         energy_ = energy;
                                         r = force - F;
                                       },
                                       [&](const algebra::Tall& x) { fill(x); },
                                       [&](const algebra::Tall& x) { return force_rounding(model_, x); }};
    const double scale = std::max(norm(model_, F), norm(model_, energy_and_force(model_, u).force));
    outcome_ = model_.newton.solve(equations, options_.tolerance, scale, u);
    scale_ = scale;
    report.newton_iterations += outcome_.iterations;
    report.factorizations += outcome_.factorizations;
    unstable_ = outcome_.iterations > 0 ? model_.newton.negative_pivots() : 0;
    if (outcome_.result == algebra::Convergence::failed || unstable_ > 0) return false;
    const auto inverted = inverted_cells(model_, u);
    const bool smooth = depth == most_halvings && norm(model_, u - state.u) <= jump * norm(model_, u);
    if (inverted > report.inverted_cells && !smooth) return false;
    report.inverted_cells = inverted;
    state = {to, std::move(u), energy_};
    return true;
  }

  void fill(const algebra::Tall& u) {
    fill_tangent(model_.tangent, model_.problem, Eigen::VectorXd::Ones(1),
                 mesh::to_vertices(model_.problem.mesh, model_.problem.dofs, u));
  }

  /// Whether the tangent ceases to be definite within the increment from `state` to the fraction `to`, looked for in
  /// the direction that the tangent at `state` foretells, no further than a smooth path may go. A path bends towards a
  /// limit point as a parabola does: its tangent foretells half of the way.
  bool loses_stability(const StaticState& state, double to) {
    fill(state.u);
    const auto [ahead, indefinite] = model_.newton.solve_linear(load_(to) - load_(state.fraction));
    const double length = norm(model_, ahead), most = jump * norm(model_, state.u);
    if (indefinite || !(length > 0 && std::isfinite(length))) return indefinite;
    fill(state.u + std::min(2.0, most / length) * ahead);
    // Without an inertia it is the softest direction that tells: two steps of inverse iteration bring it out.
    auto probe = model_.newton.solve_linear(fixed_vectors(model_.problem.mesh, model_.problem.dofs, 1, probe_stream));
    if (!probe.indefinite) probe = model_.newton.solve_linear(probe.x);
    return probe.indefinite;
  }

  std::string ending() const {
    const std::string residual = "Newton's relative residual " + shown(outcome_.residual / scale_, 3) + ", ";
    if (outcome_.result == algebra::Convergence::failed) return residual + outcome_.reason;
    if (unstable_ > 0) return residual + std::to_string(unstable_) + " negative eigenvalues of the tangent";
    return residual + "where the body has jumped and cells are inside out";
  }

  [[noreturn]] void give_up(const StaticState& state, double to) {
    const std::string where = "beyond load fraction " + shown(state.fraction, 3), how = ending();
    const bool lost = outcome_.result == algebra::Convergence::converged && unstable_ > 0;
    if (lost || loses_stability(state, to))
      throw NumericalError("statics: no stable equilibrium was found " + where +
                           ", a limit point of the load or a bifurcation (" + how + ")");
    throw NumericalError("statics: no equilibrium was found " + where + " (" + how +
                             "), nor a sign that the tangent ceases to be definite there",
                         Reason::load_steps_too_large);
  }

  FullModel& model_;
  const StaticOptions& options_;
  const LoadAt& load_;
  algebra::NewtonOutcome outcome_;
  std::int64_t unstable_ = 0;
  double energy_ = 0, scale_ = 1;
};

}  // namespace

StaticReport full_statics(FullModel& model, const StaticOptions& options, StaticState start, const LoadAt& load,
                          const std::function<void(const StaticState&, const StaticReport&)>& reached) {
  refuse_loose(model);
  Loading loading(model, options, load);
  loading.report.inverted_cells = inverted_cells(model, start.u);
  for (int step = 1; step <= options.steps; ++step) {
    const double fraction = static_cast<double>(step) / options.steps;
    if (fraction <= start.fraction * (1 + 1e-9)) continue;
    loading.advance(start, fraction, 0);
    reached(start, loading.report);
  }
  return loading.report;
}

}  // namespace ritz::stages
