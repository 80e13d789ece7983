// A multigrid cycle as a preconditioner for blocks of vectors.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "ritz/algebra/multivector.hpp"
#include "ritz/algebra/panel.hpp"

namespace ritz::algebra {

/// A symmetric V-cycle on the levels of smoothed aggregation (PETSc's GAMG) for a symmetric positive definite matrix:
/// Chebyshev-Jacobi smoothing of degree 2 on eight vectors at a time, and a dense solve on the coarsest level.
class Multigrid {
 public:
  /// *Collective*. `near_null` spans what smoothing cannot reduce, the rigid motions. Options with this prefix are read
  /// (…pc_gamg_). A must outlive this object.
  Multigrid(Mat A, const ConstTallRef& near_null, const std::string& prefix);
  ~Multigrid();

  /// *Collective*. z ≈ A⁻¹ r for all columns.
  void apply(const ConstTallRef& r, TallRef z) const;

  /// The number of levels, including the dense one.
  int levels() const;

 private:
  class Level;
  class Coarsest;

  void cycle(std::size_t level, const Panel& r, Panel& z) const;

  Preconditioner hierarchy_;
  std::vector<std::unique_ptr<Level>> levels_;  ///< finest first
  std::unique_ptr<Coarsest> coarsest_;
};

/// *Collective*. Attaches to A the vectors that GAMG's coarse levels must represent.
void attach_near_null(Mat A, const ConstTallRef& columns);

}  // namespace ritz::algebra
