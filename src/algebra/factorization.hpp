// A sparse LDLᵀ factorization by MUMPS, which solves blocks of right-hand sides and counts negative pivots; and the
// settings of MUMPS, wherever PETSc calls it.
#pragma once
#include <petscksp.h>

#include <cstdint>
#include <string>

#include "ritz/algebra/handle.hpp"
#include "ritz/algebra/multivector.hpp"

namespace ritz::algebra {

/// The estimate of the symbolic analysis, before any number is factored: sums over ranks; the largest rank for
/// memory_rank.
struct FactorEstimate {
  double flops = 0;
  double entries = 0;       ///< of the factor
  double memory_rank = 0;   ///< bytes
  double memory_total = 0;  ///< bytes
};

/// The factorization of A = K − σM: one symbolic analysis for any number of shifts σ.
class Factorization {
 public:
  /// *Collective*. Options with this prefix are read (…ksp_, …pc_, …mat_mumps_).
  Factorization(MPI_Comm comm, const std::string& prefix);

  /// *Collective*. Runs the symbolic analysis alone; only the pattern of K matters.
  FactorEstimate analyse(Mat K);

  /// *Collective*. Factors K − σM. The pattern of M must lie within that of K, which must be the same in all calls. If
  /// MUMPS needs more workspace, it gets more. Throws a NumericalError that names the matrix when the factorization
  /// fails.
  void factor(Mat K, Mat M, double sigma);

  /// *Collective*. x = A⁻¹ b for all columns, in blocks. b and x may be the same. Throws std::bad_alloc when MUMPS runs
  /// out of memory.
  void solve(const ConstTallRef& b, TallRef x) const;

  /// *Collective*. The number of negative eigenvalues of the factored matrix (Sylvester's law of inertia).
  std::int64_t negative_pivots() const;

 private:
  MPI_Comm comm_;
  Solver ksp_;
  Matrix shifted_;
  PetscInt margin_ = 0;  ///< spare workspace of MUMPS in percent; 0: MUMPS's default

  Mat prepared();
};

/// *Collective*. Makes LDLᵀ by MUMPS the preconditioner of `ksp`.
void use_mumps(KSP ksp);

/// *Collective*. The factor that `ksp`, whose operator is set, will compute; null if the user's options chose another
/// package.
Mat mumps_factor(KSP ksp);

/// *Collective*. To be called before the factorization. Switches off the parallel root, which would hide the signs of
/// its pivots from the inertia, and sets `spare` percent of extra workspace (0: MUMPS's default). The user's own
/// ICNTL(14) takes precedence.
void prepare_mumps(Mat F, PetscInt spare);

enum class MumpsFailure { memory, workspace, other };

/// Why the factorization into F failed: `memory`, `workspace` (which a larger ICNTL(14) cures) or `other`.
MumpsFailure mumps_failure(Mat F);

}  // namespace ritz::algebra
