// SLEPc's eigensolver for the smallest λ of Kψ = λMψ.
#pragma once
#include "ritz/algebra/multivector.hpp"

namespace ritz::algebra {

struct EigenPairs {
  Eigen::VectorXd values;  ///< ascending
  Tall vectors;
  int iterations = 0;
};

/// *Collective*. Krylov-Schur with shift-invert about `shift`, by MUMPS's Cholesky factorization. `deflated` are
/// M-orthonormal columns to which the search stays orthogonal. Options with the prefix modes_ reach EPS, ST, KSP and
/// PC. Returns the pairs that converged, at most `wanted`.
EigenPairs krylov_schur(Mat K, Mat M, double shift, const ConstTallRef& deflated, int wanted, double tolerance);

/// *Collective*. Sets the solver above up on a tiny problem, so that all options that it would read count as read, and
/// incompatible ones are found.
void read_eigensolver_options(MPI_Comm comm);

}  // namespace ritz::algebra
