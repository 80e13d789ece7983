// The unreduced model with its Newton solver. Vectors have one column over the free degrees of freedom.
#pragma once
#include <string>

#include "ritz/algebra/newton.hpp"
#include "ritz/stages/internal_force.hpp"

namespace ritz::stages {

/// The full model. The problem must outlive it.
struct FullModel {
  const Problem& problem;
  Tangent tangent;
  algebra::Newton newton;
};

/// *Collective*.
FullModel full_model(const Problem& problem, algebra::LinearSolver solver);

struct EnergyAndForce {
  double energy;         ///< J
  mesh::FreeRows force;  ///< f(u) = dE/du, N
};

/// *Collective*.
EnergyAndForce energy_and_force(const FullModel& model, mesh::FreeRef u);

/// *Collective*. The size of ‖f(u)‖ that rounding errors alone can cause, N: u is known to ε times its largest
/// component in a cell, which acts through the cell's stiffness.
double force_rounding(const FullModel& model, mesh::FreeRef u);

/// *Collective*. The number of cells that are inverted: det F ≤ 0 at a point of the element's rule.
std::int64_t inverted_cells(const FullModel& model, mesh::FreeRef u);

/// ‖x‖₂. *Collective*.
double norm(const FullModel& model, mesh::FreeRef x);
/// x·y. *Collective*.
double dot(const FullModel& model, mesh::FreeRef x, mesh::FreeRef y);

}  // namespace ritz::stages
