// Newton's method by PETSc's SNES for equations with a symmetric Jacobian.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "ritz/petsc/multivector.hpp"

namespace ritz::petsc {

enum class LinearSolver {
  direct,    ///< MUMPS LDLᵀ, which an indefinite Jacobian does not trouble
  iterative  ///< CG with GAMG; FGMRES where the Jacobian turns out indefinite
};

/// r(x) = 0. All functions are *Collective*.
struct Equations {
  std::function<void(const Tall& x, Tall& r)> residual;
  std::function<void(const Tall& x)> tangent;     ///< fills the matrix that Newton was made with
  std::function<double(const Tall& x)> rounding;  ///< ‖r‖ that rounding alone can make near x
};

enum class Convergence { converged, failed };

struct NewtonOutcome {
  Convergence result = Convergence::failed;
  int iterations = 0;
  int factorizations = 0;  ///< of Jacobians, or set-ups of multigrid for one
  double residual = 0;     ///< ‖r‖ at the end
  std::string reason;      ///< PETSc's word for how it ended
};

/// What one linear solve found.
struct LinearAnswer {
  Tall x;
  bool indefinite = false;  ///< the matrix, or what CG is preconditioned with, is not positive definite
};

class Newton {
 public:
  /// `jacobian` must outlive this. `near_null` spans what multigrid's smoothing cannot reduce (iterative; else no
  /// columns). Options are read under newton_ (SNES), solve_ (KSP, PC and MUMPS) and multigrid_ (GAMG).
  Newton(Mat jacobian, LinearSolver solver, const ConstTallRef& near_null);

  /// From x on, until ‖r‖ ≤ tolerance·scale or, where rounding makes more than that, ≤ what rounding makes. x is
  /// changed whether or not it converged. Rethrows what the equations throw. *Collective*.
  NewtonOutcome solve(const Equations& equations, double tolerance, double scale, Tall& x);

  /// Negative eigenvalues of the last Jacobian that was factored; 0 without a factorization. *Collective*.
  std::int64_t negative_pivots() const;

  /// J x = b by the Jacobian's values of now; x is not finite where that failed. That J is indefinite is told by the
  /// inertia of its factorization, or by CG where it meets a direction of negative curvature, or by xᵀJx = xᵀb < 0.
  /// *Collective*.
  LinearAnswer solve_linear(const Tall& b);

  SNES snes() const { return snes_; }

 private:
  NonlinearSolver snes_;
  Mat jacobian_;
  LinearSolver solver_;
  PetscInt spare_ = 50;  ///< percent of workspace that MUMPS gets beyond what it foresees
};

/// Makes the solver once on nothing, so that every option under newton_ counts as read. *Collective*.
void read_newton_options(MPI_Comm comm);

}  // namespace ritz::petsc
