// A sparse LDLᵀ factorization by MUMPS that solves blocks of right-hand sides and counts negative pivots.
#pragma once
#include <cstdint>
#include <string>

#include "ritz/petsc/handle.hpp"
#include "ritz/petsc/multivector.hpp"

namespace ritz::petsc {

/// What the analysis says before any number is factored (summed over ranks; the largest rank for memory_rank).
struct FactorEstimate {
  double flops = 0;
  double entries = 0;       ///< of the factor
  double memory_rank = 0;   ///< bytes
  double memory_total = 0;  ///< bytes
};

/// Of A = K − σM: one symbolic analysis, any number of shifts σ.
class Factorization {
 public:
  /// Options are read under `prefix` (…ksp_, …pc_, …mat_mumps_). *Collective*.
  Factorization(MPI_Comm comm, const std::string& prefix);

  /// The analysis alone. The pattern of K is what counts. *Collective*.
  FactorEstimate analyse(Mat K);

  /// Factors K − σM; M's pattern lies within K's, and K's pattern is that of all earlier calls. More workspace is given
  /// when MUMPS asks for it. Throws NumericalError that names the matrix when the factorization fails. *Collective*.
  void factor(Mat K, Mat M, double sigma);

  /// x = A⁻¹ b for all columns, in blocks. b and x may be the same. Throws std::bad_alloc where MUMPS has no memory for
  /// it. *Collective*.
  void solve(const ConstTallRef& b, TallRef x) const;

  /// How many eigenvalues of the factored matrix are negative (Sylvester's law of inertia). *Collective*.
  std::int64_t negative_pivots() const;

 private:
  MPI_Comm comm_;
  Solver ksp_;
  Matrix shifted_;
  PetscInt margin_ = 0;  ///< MUMPS's spare workspace in percent; 0: its own choice

  Mat prepared();
};

}  // namespace ritz::petsc
