// The stiffness matrix of one cell at rest.
#pragma once
#include "ritz/fem/law.hpp"

namespace ritz::fem {

/// K = ∫ ∂²W/∂u² at u = 0, by the element's rule, N/m, exactly symmetric. Its blocks are K_ab = λ P + μ Pᵀ + μ tr(P) I
/// with P = ∫ ∇N_a ∇N_bᵀ. `x` are the vertices, 3 x vertices, m. Allocates nothing.
CellMatrix stiffness(CellType type, const CellVectors& x, const ElasticConstants& material);

}  // namespace ritz::fem
