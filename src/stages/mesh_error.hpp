// Estimates the discretization error of each mode: by how much its frequency is too high because of the mesh.
#pragma once
#include <functional>
#include <string>

#include "ritz/stages/linear_modes.hpp"

namespace ritz::stages {

/// *Collective*. Why `mesh_errors` cannot estimate on this mesh, as a sentence; empty where it can.
std::string mesh_error_obstacle(const mesh::Mesh& mesh);

/// The strategy for a problem with so many degrees of freedom.
using StrategyFor = std::function<Strategy(const mesh::Dofs&)>;

/// *Collective*. For each mode f_h / f − 1, where f_h is its frequency and f the estimated one of the same body without
/// discretization error; 0 for a rigid mode. The shape of the mesh is taken as the body's: what straight edges cut off
/// a curved surface is not part of the error.
///
/// Tet4, Hex8, Wedge6: the mode ψ is taken to the same cells with quadratic shape functions, whose matrices are K₂ and
/// M₂, where one step of inverse iteration, K₂ w = M₂ P ψ, improves it. The Rayleigh-Ritz values of span(P ψ, w), all
/// modes of a group of 16 together, give λ₂ of the mode that is most like P ψ, and f = √λ₂ / 2π. K₂ is factored, or
/// solved with by conjugate gradients and multigrid, as `strategy` says. Wedge6 takes few points for its stiffness, so
/// its error may be negative.
///
/// Tet10: 4π² f² = λ_h − 1.4 ∫ (ε* − ε) : C : (ε* − ε), where ε* are the recovered strains of patch_recovery.hpp. The
/// factor stands for what these lack themselves; it was chosen by refinement studies, where without it errors were
/// estimated at 0.37 to 1.41 times their size.
///
/// The mesh must have no obstacle. Throws NumericalError when K₂ cannot be solved with.
Eigen::VectorXd mesh_errors(const Problem& problem, const ModesResult& modes, const StrategyFor& strategy);

}  // namespace ritz::stages
