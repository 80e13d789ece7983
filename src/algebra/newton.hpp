// Newton's method, by PETSc's SNES, for equations with a symmetric Jacobian.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "ritz/algebra/multivector.hpp"

namespace ritz::algebra {

enum class LinearSolver {
  direct,    ///< MUMPS's LDLᵀ, which also handles an indefinite Jacobian
  iterative  ///< CG with GAMG; FGMRES if the Jacobian is found to be indefinite
};

/// The equations r(x) = 0. All functions are *Collective*.
struct Equations {
  std::function<void(const Tall& x, Tall& r)> residual;
  std::function<void(const Tall& x)> tangent;     ///< fills the matrix that was given to Newton with dr/dx
  std::function<double(const Tall& x)> rounding;  ///< the size of ‖r‖ that rounding errors alone cause near x
};

enum class Convergence { converged, failed };

struct NewtonOutcome {
  Convergence result = Convergence::failed;
  int iterations = 0;
  int factorizations = 0;  ///< of Jacobians, or set-ups of multigrid for one
  double residual = 0;     ///< ‖r‖ at the end
  std::string reason;      ///< PETSc's name of the reason why it ended
};

/// The result of one linear solve.
struct LinearAnswer {
  Tall x;
  bool indefinite = false;  ///< the matrix, or the preconditioner of CG, is not positive definite
};

class Newton {
 public:
  /// `jacobian` must outlive this object. `near_null` spans what the smoothing of multigrid cannot reduce (for the
  /// iterative solver; else no columns). Options are read with the prefixes newton_ (SNES), solve_ (KSP, PC and MUMPS)
  /// and multigrid_ (GAMG).
  Newton(Mat jacobian, LinearSolver solver, const ConstTallRef& near_null);

  /// *Collective*. Iterates from x until ‖r‖ ≤ tolerance·scale or, if rounding errors exceed that, until
  /// ‖r‖ ≤ rounding(x). x is changed whether or not the iteration converges. Rethrows what the equations throw.
  NewtonOutcome solve(const Equations& equations, double tolerance, double scale, Tall& x);

  /// *Collective*. The number of negative eigenvalues of the last Jacobian that was factored; 0 without a
  /// factorization.
  std::int64_t negative_pivots() const;

  /// *Collective*. Solves J x = b with the present values of the Jacobian; on failure x is not finite. J counts as
  /// indefinite by the inertia of its factorization, or when CG meets a direction of negative curvature, or when
  /// xᵀJx = xᵀb < 0.
  LinearAnswer solve_linear(const Tall& b);

  SNES snes() const { return snes_; }

 private:
  NonlinearSolver snes_;
  Mat jacobian_;
  LinearSolver solver_;
  PetscInt spare_ = 50;  ///< extra workspace of MUMPS in percent
};

/// *Collective*. Sets a solver up without equations, so that every option with the prefix newton_ counts as read.
void read_newton_options(MPI_Comm comm);

}  // namespace ritz::algebra
