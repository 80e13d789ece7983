// What a scene asks of ritz-full, and the state with which the run starts.
#pragma once
#include "ritz/config/config.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/stages/full_dynamics.hpp"

namespace ritz::app {

/// *Collective*. The linear solver that -solver asks for, or by default one that fits.
algebra::LinearSolver linear_solver(const config::Config& config, const mesh::Dofs& dofs);

/// *Collective*. Reads a scene, replicated on all ranks. Throws InputError on all ranks.
scene::Scene read_scene(MPI_Comm comm, const std::filesystem::path& path);

/// *Collective*. The same for ritz-full. Throws InputError also for what the full model does not support.
scene::Scene read_full_scene(MPI_Comm comm, const std::filesystem::path& path);

stages::FullIntegrator integrator_of(const scene::Time& time);

/// The name of the integrator of a scene, as scenes spell it; "none" for statics.
std::string integrator_name(const scene::Scene& scene);

/// *Collective*. The first state: at rest; that of a motion file which the scene names, at t = 0; or the last state of
/// an earlier run (-restart). Time continues from the last state of a motion; from a static state, which is released,
/// it starts at 0. If another integrator computed the last state, `a` has no columns. Throws InputError on all ranks.
stages::DynamicState first_state(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                 const scene::Scene& scene, const std::string& problem_checksum);

/// *Collective*. The start of a scene that begins in equilibrium under the loads at t = 0: at rest. Throws InputError
/// or NumericalError on all ranks when there is no such state.
stages::DynamicState static_start(stages::FullModel& model, const stages::LoadAt& load);

/// The number of steps of the scene after `from`, without listing them; for statics an upper bound.
std::int64_t step_count_from(const scene::Scene& scene, double from);

/// The times (or load fractions) of the scene's steps from `from` on, including `from`. Throws InputError when there
/// are no others.
std::vector<double> times_from(const scene::Scene& scene, double from);

}  // namespace ritz::app
