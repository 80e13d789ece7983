// Runs of the full model that keep their states.
#pragma once
#include "ritz/parallel/comm.hpp"
#include "ritz/stages/full_dynamics.hpp"
#include "support/problem.hpp"

namespace ritz::test {

struct FullRun {
  Problem p;
  algebra::LinearSolver solver = algebra::LinearSolver::direct;
  stages::FullModel model = stages::full_model(p, solver);

  algebra::Tall zeros() const { return algebra::Tall::Zero(p.dofs.owned, 1); }
  algebra::Tall free(const algebra::Tall& force) const { return mesh::from_vertices(p.mesh, p.dofs, force); }

  /// The displacements at load fraction 1 of the proportional load F.
  algebra::Tall statics(const algebra::Tall& F, int steps) {
    algebra::Tall u;
    stages::full_statics(
        model, {.steps = steps}, {0, zeros(), 0}, [&](double t) -> algebra::Tall { return t * F; },
        [&](const stages::StaticState& state, const stages::StaticReport&) { u = state.u; });
    return u;
  }

  /// The mean displacement over a set.
  Eigen::Vector3d mean(const algebra::Tall& u, const std::string& set) const {
    const mesh::Set& found = *p.mesh.find(set);
    const algebra::Tall all = mesh::to_vertices(p.mesh, p.dofs, u);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(3, 1);
    for (const int v : found.vertices)
      if (v < p.mesh.owned) sum += all.col(0).segment<3>(3 * v);
    parallel::sum_in_place(p.mesh.comm, sum);
    return sum / static_cast<double>(found.vertices_total);
  }

  stages::DynamicState motion(const stages::DynamicOptions& options, const stages::DynamicState& start,
                              std::int64_t steps, const stages::LoadAt& load, stages::DynamicReport* report = nullptr) {
    const auto first = stages::start_dynamics(model, options, start, load);
    stages::DynamicState last = first;
    const auto done =
        stages::full_dynamics(model, options, first, steps, load,
                              [&](const stages::DynamicState& state, const stages::DynamicReport&) { last = state; });
    if (report) *report = done;
    return last;
  }

  stages::DynamicState rest() const { return {0, zeros(), zeros(), zeros(), {}}; }
};

}  // namespace ritz::test
