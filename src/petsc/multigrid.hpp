// One multigrid cycle as a preconditioner for blocks of vectors.
#pragma once
#include <string>

#include "ritz/petsc/multivector.hpp"

namespace ritz::petsc {

/// A V-cycle of smoothed aggregation (PETSc's GAMG) on a symmetric positive definite matrix.
class Multigrid {
 public:
  /// `near_null` spans what smoothing cannot reduce: the rigid motions. Options are read under `prefix` (…pc_, …mg_).
  /// A must outlive this. *Collective*.
  Multigrid(Mat A, const ConstTallRef& near_null, const std::string& prefix);

  /// z ≈ A⁻¹ r for all columns, by one symmetric cycle each. *Collective*.
  void apply(const ConstTallRef& r, TallRef z) const;

 private:
  Mat A_;
  Preconditioner cycle_;
};

}  // namespace ritz::petsc
