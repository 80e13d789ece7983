// The stiffness matrix of one cell at rest, and its consistent mass matrix.
#pragma once
#include "ritz/fem/law.hpp"
#include "ritz/fem/types.hpp"

namespace ritz::fem {

/// K = ∫ ∂²W/∂u² at u = 0, by the element's rule, N/m, exactly symmetric. Its blocks are K_ab = λ P + μ Pᵀ + μ tr(P) I
/// with P = ∫ ∇N_a ∇N_bᵀ, and Σ_mn C_imjn P_mn of an anisotropic material. `x` are the vertices, 3 x vertices, m.
/// Allocates nothing.
CellMatrix stiffness(CellType type, const CellVectors& x, const ElasticConstants& material);

/// The exact scalar consistent mass M_s, vertices x vertices, kg: M_ab = ∫ ρ N_a N_b. The mass matrix of the cell is
/// M_s ⊗ I₃. `x` are the vertices, 3 x vertices, m; `density` is in kg/m³. Exactly symmetric; positive definite if det
/// J > 0 throughout. Allocates nothing.
VertexMatrix mass(CellType type, const CellVectors& x, double density);

/// The same, always computed by the element's mass rule, which is exact for every shape that the cell can have. Where
/// there is a closed form, mass() takes that.
VertexMatrix mass_by_quadrature(CellType type, const CellVectors& x, double density);

}  // namespace ritz::fem
