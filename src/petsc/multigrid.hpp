// One multigrid cycle as a preconditioner for blocks of vectors.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "ritz/petsc/multivector.hpp"
#include "ritz/petsc/panel.hpp"

namespace ritz::petsc {

/// A symmetric V-cycle on the levels of smoothed aggregation (PETSc's GAMG) for a symmetric positive definite matrix:
/// Chebyshev-Jacobi smoothing of degree 2, eight vectors at a time, a dense solve on the coarsest level.
class Multigrid {
 public:
  /// `near_null` spans what smoothing cannot reduce: the rigid motions. Options are read under `prefix` (…pc_gamg_).
  /// A must outlive this. *Collective*.
  Multigrid(Mat A, const ConstTallRef& near_null, const std::string& prefix);
  ~Multigrid();

  /// z ≈ A⁻¹ r for all columns. *Collective*.
  void apply(const ConstTallRef& r, TallRef z) const;

  /// Levels, the dense one too.
  int levels() const;

 private:
  class Level;
  class Coarsest;

  void cycle(std::size_t level, const Panel& r, Panel& z) const;

  Preconditioner hierarchy_;
  std::vector<std::unique_ptr<Level>> levels_;  ///< finest first
  std::unique_ptr<Coarsest> coarsest_;
};

/// Tells GAMG what the coarse levels must represent. *Collective*.
void attach_near_null(Mat A, const ConstTallRef& columns);

}  // namespace ritz::petsc
