// The unreduced model, ready for Newton's method. Vectors are over the free degrees of freedom, one column.
#pragma once
#include <string>

#include "ritz/petsc/newton.hpp"
#include "ritz/stages/tangent.hpp"

namespace ritz::stages {

/// The problem must outlive it.
struct FullModel {
  const Problem& problem;
  Tangent tangent;
  petsc::Newton newton;
};

/// *Collective*.
FullModel full_model(const Problem& problem, petsc::LinearSolver solver);

struct EnergyAndForce {
  double energy;         ///< J
  mesh::FreeRows force;  ///< f(u) = dE/du, N
};

/// *Collective*.
EnergyAndForce energy_and_force(const FullModel& model, mesh::FreeRef u);

/// What rounding can make of ‖f(u)‖, N: u known to ε times its largest component in a cell, through the cell's
/// stiffness. *Collective*.
double force_rounding(const FullModel& model, mesh::FreeRef u);

/// Cells that are turned inside out somewhere: det F ≤ 0 at a point of the element's rule. *Collective*.
std::int64_t inverted_cells(const FullModel& model, mesh::FreeRef u);

/// ‖x‖₂. *Collective*.
double norm(const FullModel& model, mesh::FreeRef x);
/// x·y. *Collective*.
double dot(const FullModel& model, mesh::FreeRef x, mesh::FreeRef y);

}  // namespace ritz::stages
