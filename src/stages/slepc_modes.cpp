#include "ritz/base/error.hpp"
#include "ritz/petsc/check.hpp"
#include "ritz/petsc/eigensolver.hpp"
#include "ritz/stages/eigen_strategy.hpp"
#include "ritz/stages/rigid_modes.hpp"

namespace ritz::stages {
namespace {

constexpr double solver_tolerance = 2e-9;
constexpr int attempts = 3;

/// K − σM, what the multigrid cycle is built on.
petsc::Matrix shifted(const Full& full, double sigma) {
  petsc::Matrix A;
  petsc::check(MatDuplicate(full.stiffness, MAT_COPY_VALUES, A.out()));
  petsc::check(MatAXPY(A, -sigma, full.mass, SUBSET_NONZERO_PATTERN));
  return A;
}

Found cleaned(const EigenProblem& problem, petsc::EigenPairs pairs, const std::string& solver, int wanted) {
  if (pairs.values.size() < wanted)
    throw NumericalError(solver + " converged to " + std::to_string(pairs.values.size()) + " of " +
                         std::to_string(wanted) + " modes in " + std::to_string(pairs.iterations) +
                         " iterations; use -solver direct, or raise -modes_eps_max_it");
  return {rayleigh_ritz(problem.full.stiffness, problem.full.mass, problem.rigid, std::move(pairs.vectors)),
          pairs.iterations};
}

}  // namespace

Found find_by_krylov_schur(const EigenProblem& problem, int wanted) {
  return cleaned(problem,
                 petsc::krylov_schur(problem.full.stiffness, problem.full.mass, safe_shift(problem), problem.rigid,
                                     wanted, 1e-12),
                 "SLEPc's Krylov-Schur", wanted);
}

Found find_iteratively(const EigenProblem& problem, int wanted) {
  const petsc::Matrix P = shifted(problem.full, safe_shift(problem));
  const petsc::Tall motions = near_null_space(problem.mesh, problem.dofs);
  Found found;
  found.pairs.vectors.resize(problem.rigid.rows(), 0);
  // The solver estimates ‖Mψ‖; what counts is the true residual, so it goes on from what it has with a smaller bound.
  double tolerance = solver_tolerance;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    found = cleaned(problem,
                    petsc::davidson(problem.full.stiffness, problem.full.mass, P, motions, problem.rigid,
                                    found.pairs.vectors, wanted, tolerance),
                    "SLEPc's generalized Davidson", wanted);
    const Residuals r = residuals(problem.full.stiffness, problem.full.mass, problem.norm_K, found.pairs);
    const double excess = (r.relative.array() / r.gate.array()).maxCoeff();
    if (excess <= 1) break;
    tolerance *= 0.3 / excess;
  }
  return found;
}

}  // namespace ritz::stages
