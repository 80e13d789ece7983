// The internal forces of cells, projected onto a basis, at many states u = U z at once.
#pragma once
#include <functional>
#include <span>

#include "ritz/model/model.hpp"
#include "ritz/stages/assemble.hpp"
#include "ritz/stages/each_cell.hpp"

namespace ritz::stages {

/// A basis U at all vertices that this rank holds.
struct CellBasis {
  const Problem& problem;
  model::RowMatrix rows;  ///< 3 x local vertices, r

  Eigen::Index size() const { return rows.cols(); }
};

/// *Collective*. `u`: rows of owned vertices, 3 for each.
CellBasis cell_basis(const Problem& problem, mesh::VertexRef u);

/// What the force of one cell over the basis is computed from.
struct CellPoints {
  Eigen::MatrixXd gradients;  ///< r x 9P for P quadrature points: column 9p + 3j + i has ∂u_i/∂X_j of the columns of U
  Eigen::VectorXd volumes;  ///< P, m³
};

CellPoints cell_points(const CellBasis& basis, int cell);

/// Of the whole body, for each of N states.
struct ProjectedForces {
  Eigen::MatrixXd forces;    ///< Uᵀf(Uz), r x N, N/√kg
  Eigen::VectorXd energies;  ///< J
  Eigen::VectorXd squeezed;  ///< the smallest det F of any quadrature point; 0 where a law does not admit the state
};

/// *Collective*. By the laws of the materials, at the columns of z, r x N. The sum of forces over cells is
/// compensated: its rounding error does not grow with the mesh.
ProjectedForces projected_forces(const CellBasis& basis, const Eigen::MatrixXd& z);

/// Takes the force of a cell, by its place among the cells that were asked for: r x N, N/√kg.
using TakeForce = std::function<void(Eigen::Index place, const Eigen::Ref<const Eigen::MatrixXd>& force)>;

/// The force of each of these local cells, of equal regions side by side for speed, at the columns of z, r x N: by the
/// law of its material, or with Integrand::beyond_polynomial by what that has beyond the St. Venant-Kirchhoff law of
/// the same constants at rest.
void each_cell_force(const CellBasis& basis, model::Integrand integrand, std::span<const int> cells,
                     const Eigen::MatrixXd& z, const TakeForce& take);

}  // namespace ritz::stages
