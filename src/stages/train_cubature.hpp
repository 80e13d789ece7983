// Which cells a cubature has, and their weights: trained on poses of the reduced body (Eqs. 8-11 of the notes).
#pragma once
#include <optional>

#include "ritz/model/model.hpp"
#include "ritz/stages/linear_modes.hpp"

namespace ritz::stages {

/// The number of poses of each kind, lifts and statics, on which a cubature is tested and not trained.
inline constexpr int held_out_poses = 20;

struct CubatureOptions {
  std::optional<int> cells;  ///< T; nothing: as many as the tolerance needs
  double tolerance = 1e-3;   ///< of both root mean square errors of held-out poses
  model::Integrand integrand = model::Integrand::beyond_polynomial;
  int poses = 120;        ///< to train on: the first half lifts, the others statics
  double amplitude = .5;  ///< of the poses: largest displacement over the largest extent of the body
};

/// *Collective*. `u` is the basis over owned vertices, 3 rows for each; `stiffness` Λ the diagonal of UᵀKU, whose other
/// entries are zero; `polynomial` that of the St. Venant-Kirchhoff laws of all materials' constants at rest.
///
/// Weights w ≥ 0 minimise Σ_s ‖Λ^(−½)(f̃(z_s) − f(z_s))‖² / ‖Λ^(−½) f(z_s)‖² over the poses z_s, where f = Uᵀf(Uz) is
/// the exact sum over all cells; cells enter by nonnegative_least_squares. Candidates are the cells whose law is no
/// polynomial, or of Integrand::energy all; of more than 20,000 a sample, of cells of every size, that depends on their
/// numbers in the file alone. The errors are measured on held-out poses at every T that is 1.25 times the last.
///
/// Throws InputError for a basis with rigid modes, where there is no candidate, and for more cells than candidates;
/// NumericalError when there are not as many cells with positive weights, or the tolerance is not reached with half as
/// many cells as the poses have components together.
model::Cubature train_cubature(const Problem& problem, mesh::VertexRef u, const Eigen::VectorXd& stiffness,
                               const model::Polynomial& polynomial, const CubatureOptions& options,
                               const ModesProgress& progress);

}  // namespace ritz::stages
