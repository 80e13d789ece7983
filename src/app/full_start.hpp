// What a run of ritz-full is told by its scene, and where it starts.
#pragma once
#include "ritz/config/config.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/stages/full_dynamics.hpp"

namespace ritz::app {

/// What -solver asks for, or what fits. *Collective*.
petsc::LinearSolver linear_solver(const config::Config& config, const mesh::Dofs& dofs);

/// The scene, the same on all ranks. Throws InputError. *Collective*.
scene::Scene read_scene(MPI_Comm comm, const std::filesystem::path& path);

/// The same for ritz-full. Throws InputError also for what the full model cannot do. *Collective*.
scene::Scene read_full_scene(MPI_Comm comm, const std::filesystem::path& path);

stages::FullIntegrator integrator_of(const scene::Time& time);

/// The integrator of a scene's motion as scenes name it; "none" of statics.
std::string integrator_name(const scene::Scene& scene);

/// At rest, or where an earlier run stopped. Time goes on from a motion's last state; from a static one, released, it
/// starts at 0. Where another integrator made the last state, `a` has no column. Throws InputError. *Collective*.
stages::DynamicState first_state(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                 const scene::Scene& scene, const std::string& problem_checksum);

/// How many of the scene's steps lie beyond `from`, before anything is listed; of statics at most.
std::int64_t step_count_from(const scene::Scene& scene, double from);

/// Times (or load fractions) from `from` on that the scene's steps reach, `from` included. Throws InputError when there
/// are no others.
std::vector<double> times_from(const scene::Scene& scene, double from);

}  // namespace ritz::app
