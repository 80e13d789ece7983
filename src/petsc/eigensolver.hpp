// SLEPc's eigensolvers for Kψ = λMψ, smallest λ first.
#pragma once
#include "ritz/petsc/multivector.hpp"

namespace ritz::petsc {

struct EigenPairs {
  Eigen::VectorXd values;  ///< ascending
  Tall vectors;
  int iterations = 0;
};

/// Krylov-Schur under shift-invert about `shift`, MUMPS Cholesky inside. `deflated`: M-orthonormal columns to keep
/// out. Options under modes_ reach EPS, ST, KSP and PC. Returns what converged, at most `wanted`. *Collective*.
EigenPairs krylov_schur(Mat K, Mat M, double shift, const ConstTallRef& deflated, int wanted, double tolerance);

/// Generalized Davidson with one multigrid cycle (GAMG) on P as the preconditioner: no factorization. `near_null`
/// spans what smoothing cannot reduce (rigid motions). `start`: a first guess, or no columns. The residual is measured
/// relative to λ‖Mψ‖, with the size that ‖Mψ‖ has for a smooth ψ on an even mesh. *Collective*.
EigenPairs davidson(Mat K, Mat M, Mat P, const ConstTallRef& near_null, const ConstTallRef& deflated,
                    const ConstTallRef& start, int wanted, double tolerance);

/// Makes the solvers above once on nothing, so that every option that they would read counts as read. *Collective*.
void read_eigensolver_options(MPI_Comm comm);

}  // namespace ritz::petsc
