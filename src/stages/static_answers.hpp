// Unit loads, how the body answers them in statics, and what a basis misses of that.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ritz/stages/assemble.hpp"
#include "ritz/stages/inverse.hpp"
#include "ritz/stages/rayleigh_ritz.hpp"

namespace ritz::stages {

/// Where a unit load acts: a total force of 1 N that the vertices of a set share equally, or (no set) gravity of 1 m/s²
/// on all of the mass. Each has three directions, x, y and z.
using LoadPlace = std::optional<std::string>;

/// Unit loads b, N over free degrees of freedom: three columns for each place, along x, y and z.
struct UnitLoads {
  std::vector<LoadPlace> places;
  mesh::FreeRows columns;
};

/// *Collective*. The sets must exist and have vertices.
UnitLoads unit_loads(const Problem& problem, const std::vector<LoadPlace>& places);

/// *Collective*. The static answers w to loads b, a column each: K w = b, m. If the body can move rigidly, they are
/// those of inertia relief: K w = (I − M R Rᵀ) b with RᵀMw = 0, where R are the M-orthonormal `rigid` modes, and the
/// inertia of the rigid motion that b excites balances it [Craig & Kurdila, Fundamentals of Structural Dynamics, 2006,
/// ch. 17; MSC Nastran, inertia relief]. The column of a load that supports or inertia bear whole is exactly zero.
/// Throws NumericalError when a solve does not converge.
mesh::FreeRows static_answers(const Matrices& matrices, const Inverse& inverse, const algebra::Tall& rigid,
                              double norm_K, mesh::FreeRef loads);

/// *Collective*. Residual vectors [Dickens, Nakagawa & Wittbrodt, Computers & Structures 62, 1997]: what the static
/// `answers` w have outside the span of the M-orthonormal columns `against`. They are M-orthonormal, M-orthogonal to
/// `against`, and XᵀKX is diagonal, the `values` (rad²/s²), ascending. A basis that spans both is exact in the statics
/// of these loads. Left out is what matters to none of them: directions with less than 1e-7 of the size √(wᵀKw) of
/// every answer.
RitzPairs residual_vectors(const Problem& problem, mesh::FreeRef against, mesh::FreeRef answers);

/// The static truncation error of a basis for one unit load.
struct StaticError {
  LoadPlace place;
  int axis = 0;        ///< 0, 1, 2: along x, y, z
  double missing = 0;  ///< ‖w − Uz‖_K / ‖w‖_K at the basis's own answer z
};

/// *Collective*. √(1 − bᵀU(UᵀKU)⁻¹Uᵀb / bᵀK⁻¹b) for each load that has an answer. `stiffness` is the diagonal of UᵀKU,
/// whose other entries are zero; columns of zero stiffness, rigid motions, have no part in it.
std::vector<StaticError> static_errors(const Problem& problem, mesh::FreeRef U, const Eigen::VectorXd& stiffness,
                                       const UnitLoads& loads, mesh::FreeRef answers);

}  // namespace ritz::stages
