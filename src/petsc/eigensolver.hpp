// SLEPc's eigensolver for Kψ = λMψ, smallest λ first.
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

/// Sets the solver above up once on a tiny problem, so that every option that it would read counts as read, and those
/// that do not go together are found. *Collective*.
void read_eigensolver_options(MPI_Comm comm);

}  // namespace ritz::petsc
