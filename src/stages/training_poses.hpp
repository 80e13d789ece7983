// Poses of a reduced body that a cubature is trained and tested on, and the exact forces there.
#pragma once
#include <cstdint>
#include <vector>

#include "ritz/model/model.hpp"
#include "ritz/stages/cell_forces.hpp"

namespace ritz::stages {

/// How a pose z is made of random p: as p and its correction of second order, z_k = p_k − ½ B_ijk p_i p_j / Λ_k; or as
/// the equilibrium under the load Λp, f̃(z) = Λp. B and f̃ are of the body's polynomial.
enum class PoseKind : std::uint8_t { lift, statics };

/// Poses of one kind. Two draws of one stream are the same random numbers.
struct PoseDraw {
  PoseKind kind;
  int count;
  std::uint64_t stream;
};

struct PoseSource {
  const CellBasis& basis;
  mesh::VertexRef u;                    ///< the basis over owned vertices, 3 rows for each
  const Eigen::VectorXd& stiffness;     ///< Λ, the diagonal of UᵀKU, r, rad²/s², > 0
  const model::Polynomial& polynomial;  ///< of the St. Venant-Kirchhoff laws of the constants at rest
  double amplitude;                     ///< largest displacement U p of a vertex over the largest extent of the body
};

struct Poses {
  Eigen::MatrixXd z;      ///< r x N, the draws one after the other
  ProjectedForces exact;  ///< of all cells, by the laws of the materials
};

/// *Collective*. The directions of p are normally distributed, with standard deviations Λ_1/Λ_i: in the mean the load
/// Λp has the same force along every coordinate, as a force on a point of the body has. Pose k of n in a draw has
/// (k + 1)/n of the amplitude. A pose with a quadrature point whose volume is below a fifth of that at rest, or that a
/// law does not admit, and statics that are not found, are replaced by those of p/2, until all are admitted. Throws
/// NumericalError when that does not end.
Poses training_poses(const PoseSource& source, const std::vector<PoseDraw>& draws);

}  // namespace ritz::stages
