#include "ritz/stages/full_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "ritz/algebra/matrix.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/stages/internal_force.hpp"

namespace ritz::stages {
namespace {

constexpr int most_step_halvings = 10;
constexpr int most_exact_degree = 3;  ///< of a polynomial, for two Gauss points

/// Acceleration a d + a₀ and velocity v d + v₀ in balance with Σ_k w_k f(u₀ + s_k d) and a load, d = u₁ − u₀.
struct Rule {
  double a, v;
  algebra::Tall a0, v0;
  Eigen::VectorXd points, weights;
  algebra::Tall load;
};

/// Gauss-Legendre on [0, 1]: points, then weights.
using Gauss = std::pair<Eigen::VectorXd, Eigen::VectorXd>;

/// What integrates the force along a step: two points are exact for cubic forces; four leave of a law's energy, whose
/// force is no polynomial, some 1e-12 in hundreds of large steps.
Gauss gauss(const fem::Materials& materials) {
  if (fem::force_degree(materials).value_or(most_exact_degree + 1) <= most_exact_degree) {
    const double at = std::sqrt(3.0) / 6;
    return {Eigen::Vector2d(.5 - at, .5 + at), Eigen::Vector2d(.5, .5)};
  }
  const double near = .5 * std::sqrt(3. / 7 - 2. / 7 * std::sqrt(1.2)),
               far = .5 * std::sqrt(3. / 7 + 2. / 7 * std::sqrt(1.2));
  const double inner = (18 + std::sqrt(30.0)) / 72, outer = (18 - std::sqrt(30.0)) / 72;
  return {Eigen::Vector4d(.5 - far, .5 - near, .5 + near, .5 + far), Eigen::Vector4d(outer, inner, inner, outer)};
}

Rule rule(const fem::Materials& materials, FullIntegrator integrator, const DynamicState& s, double dt,
          const algebra::Tall& F0, const algebra::Tall& F1) {
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  const algebra::Tall none = algebra::Tall::Zero(s.u.rows(), 1);
  switch (integrator) {
    case FullIntegrator::avf: {
      const auto [points, weights] = gauss(materials);
      return {2 / (dt * dt), 1 / dt, -2 / dt * s.v, none, points, weights, (F0 + F1) / 2};
    }
    case FullIntegrator::newmark: return {4 / (dt * dt), 2 / dt, -4 / dt * s.v - s.a, -s.v, one, one, F1};
    case FullIntegrator::implicit_euler: break;
  }
  return {1 / (dt * dt), 1 / dt, -s.v / dt, none, one, one, F1};
}

algebra::Tall damp(const FullModel& model, const DynamicOptions& options, const algebra::Tall& v) {
  algebra::Tall force = algebra::Tall::Zero(v.rows(), 1);
  if (options.alpha != 0) force += options.alpha * algebra::multiply(model.problem.matrices.mass, v);
  if (options.beta != 0) force += options.beta * algebra::multiply(model.problem.matrices.stiffness, v);
  return force;
}

/// The equations of one step for d.
class StepEquations {
 public:
  StepEquations(FullModel& model, const DynamicOptions& options, const Rule& rule, const algebra::Tall& u0)
      : model_(model), options_(options), rule_(rule), u0_(u0) {}

  algebra::Equations equations() {
    return {[this](const algebra::Tall& d, algebra::Tall& r) { r = residual(d); },
            [this](const algebra::Tall& d) { tangent(d); },
            [this](const algebra::Tall& d) { return force_rounding(model_, u0_ + d); }};
  }

  /// The sum of the norms of the forces in balance where the step begins: a guess of its end may be far from anything
  /// that happens, and its forces no measure.
  double scale() const {
    const algebra::Tall d = algebra::Tall::Zero(u0_.rows(), 1);
    return norm(model_, inertia(d)) + norm(model_, damping(d)) + norm(model_, internal(d)) + norm(model_, rule_.load);
  }

  /// `d`, or 0 where that is nearer to balance.
  algebra::Tall better_than_none(const algebra::Tall& d) const {
    const algebra::Tall none = algebra::Tall::Zero(d.rows(), 1);
    return norm(model_, residual(d)) < norm(model_, residual(none)) ? d : none;
  }

 private:
  algebra::Tall inertia(const algebra::Tall& d) const {
    return algebra::multiply(model_.problem.matrices.mass, rule_.a * d + rule_.a0);
  }
  algebra::Tall damping(const algebra::Tall& d) const { return damp(model_, options_, rule_.v * d + rule_.v0); }

  /// u₀ + s_k d over vertices, a column each.
  algebra::Tall stations(const algebra::Tall& d) const {
    algebra::Tall u(d.rows(), rule_.points.size());
    for (Eigen::Index k = 0; k < u.cols(); ++k) u.col(k) = u0_.col(0) + rule_.points[k] * d.col(0);
    return mesh::to_vertices(model_.problem.mesh, model_.problem.dofs, u);
  }

  algebra::Tall internal(const algebra::Tall& d) const {
    const auto sums = internal_forces(model_.problem.mesh, model_.problem.materials, stations(d));
    return mesh::from_vertices(model_.problem.mesh, model_.problem.dofs, sums.forces) * rule_.weights;
  }

  algebra::Tall residual(const algebra::Tall& d) const { return inertia(d) + damping(d) + internal(d) - rule_.load; }

  void tangent(const algebra::Tall& d) {
    const algebra::Matrix& J = model_.tangent.matrix;
    const Eigen::VectorXd weights = rule_.weights.cwiseProduct(rule_.points);
    fill_tangent(model_.tangent, model_.problem, weights, stations(d));
    const auto& matrices = model_.problem.matrices;
    algebra::add(J, rule_.a + options_.alpha * rule_.v, matrices.mass, algebra::Pattern::subset);
    if (options_.beta != 0) algebra::add(J, options_.beta * rule_.v, matrices.stiffness, algebra::Pattern::same);
  }

  FullModel& model_;
  const DynamicOptions& options_;
  const Rule& rule_;
  const algebra::Tall& u0_;
};

class Motion {
 public:
  Motion(FullModel& model, const DynamicOptions& options, const LoadAt& load)
      : model_(model), options_(options), load_(load) {}

  void advance(DynamicState& state, double dt, int depth) {
    if (auto next = step(state, dt)) {
      state = std::move(*next);
      return;
    }
    ++report.rejected;
    if (depth == most_step_halvings) give_up(state, dt);
    advance(state, dt / 2, depth + 1);
    advance(state, dt / 2, depth + 1);
  }

  DynamicReport report;

 private:
  /// Nothing where Newton did not converge.
  std::optional<DynamicState> step(const DynamicState& now, double dt) {
    const algebra::Tall F0 = load_(now.t), F1 = load_(now.t + dt);
    const Rule r = rule(model_.problem.materials, options_.integrator, now, dt, F0, F1);
    StepEquations equations(model_, options_, r, now.u);
    algebra::Tall d = equations.better_than_none(dt * now.v + dt * dt / 2 * now.a);
    scale_ = equations.scale();
    outcome_ = model_.newton.solve(equations.equations(), options_.tolerance, scale_, d);
    report.newton_iterations += outcome_.iterations;
    report.factorizations += outcome_.factorizations;
    if (outcome_.result == algebra::Convergence::failed) return std::nullopt;

    DynamicState next{now.t + dt, now.u + d, r.v * d + r.v0, r.a * d + r.a0, now.energies};
    if (options_.integrator == FullIntegrator::avf) next.v = 2 / dt * d - now.v;
    next.energies.work += dot(model_, d, F0 + F1) / 2;
    next.energies.dissipated += dot(model_, d, damp(model_, options_, d)) / dt;
    next.energies.kinetic = dot(model_, next.v, algebra::multiply(model_.problem.matrices.mass, next.v)) / 2;
    next.energies.elastic = energy_and_force(model_, next.u).energy;
    return next;
  }

  [[noreturn]] void give_up(const DynamicState& state, double dt) const {
    throw NumericalError("the step from t = " + shown(state.t, 3) + " s did not converge, nor when halved down to " +
                         shown(dt, 3) + " s: Newton's relative residual " + shown(outcome_.residual / scale_, 3) +
                         ", " + outcome_.reason + "; take shorter steps");
  }

  FullModel& model_;
  const DynamicOptions& options_;
  const LoadAt& load_;
  algebra::NewtonOutcome outcome_;
  double scale_ = 1;
};

}  // namespace

algebra::Tall balanced_acceleration(const FullModel& model, const DynamicOptions& options, const DynamicState& state,
                                    const LoadAt& load) {
  return algebra::solve_mass(model.problem.matrices.mass,
                             load(state.t) - damp(model, options, state.v) - energy_and_force(model, state.u).force);
}

DynamicState start_dynamics(FullModel& model, const DynamicOptions& options, DynamicState state, const LoadAt& load) {
  auto& e = state.energies;
  e.elastic = energy_and_force(model, state.u).energy;
  e.kinetic = dot(model, state.v, algebra::multiply(model.problem.matrices.mass, state.v)) / 2;
  e.start = e.kinetic + e.elastic;
  if (options.integrator == FullIntegrator::newmark) state.a = balanced_acceleration(model, options, state, load);
  return state;
}

DynamicReport full_dynamics(FullModel& model, const DynamicOptions& options, DynamicState state, std::int64_t steps,
                            const LoadAt& load,
                            const std::function<void(const DynamicState&, const DynamicReport&)>& reached) {
  Motion motion(model, options, load);
  const double start = state.t;
  for (std::int64_t n = 1; n <= steps; ++n) {
    motion.advance(state, options.dt, 0);
    state.t = start + static_cast<double>(n) * options.dt;
    const double drift = state.energies.drift();
    motion.report.gained = std::max(motion.report.gained, drift);
    motion.report.lost = std::max(motion.report.lost, -drift);
    reached(state, motion.report);
  }
  return motion.report;
}

}  // namespace ritz::stages
