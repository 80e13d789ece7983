// The stiffness matrix of one cell at rest.
#pragma once
#include "ritz/fem/law.hpp"
#include "ritz/fem/strain.hpp"

namespace ritz::fem {

/// K = ∫ ∂²W/∂u² at u = 0, by the element's rule, N/m, exactly symmetric. Row 3a + i is component i of vertex a. Its
/// blocks are K_ab = λ P + μ Pᵀ + μ tr(P) I with P = ∫ ∇N_a ∇N_bᵀ. `x` are the vertices, 3 x vertices, m. Allocates
/// nothing.
template <class E>
Matrix<3 * E::vertices, 3 * E::vertices> stiffness(const Coordinates<E>& x, const ElasticConstants& material);

}  // namespace ritz::fem
