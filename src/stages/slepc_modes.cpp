#include "ritz/algebra/eigensolver.hpp"
#include "ritz/base/error.hpp"
#include "ritz/stages/eigen_strategy.hpp"

namespace ritz::stages {

Found find_by_krylov_schur(const EigenProblem& problem, int wanted) {
  auto pairs = algebra::krylov_schur(problem.body.matrices.stiffness, problem.body.matrices.mass, safe_shift(problem),
                                     problem.rigid, wanted, 1e-12);
  if (pairs.values.size() < wanted)
    throw NumericalError("SLEPc's eigensolver converged to " + std::to_string(pairs.values.size()) + " of " +
                             std::to_string(wanted) + " modes in " + std::to_string(pairs.iterations) + " iterations",
                         Reason::foreign_solver_stopped);
  return {rayleigh_ritz(problem.body.matrices.stiffness, problem.body.matrices.mass, problem.rigid,
                        std::move(pairs.vectors)),
          pairs.iterations};
}

}  // namespace ritz::stages
