// A reduced model's own witness: what it claims, computed another way.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "ritz/model/model.hpp"
#include "ritz/stages/derivatives.hpp"

namespace ritz::stages {

using Figures = std::vector<std::pair<std::string, double>>;

/// f̃(z), Ẽ(z) and K̃(0) of the polynomial against Uᵀf(Uz), E(Uz) and UᵀKU of the full model, at random z whose largest
/// displacements are 1e-6 ... 1e2 times a tenth of the body's size (nine decades); relative errors, the largest of
/// each. `u`: the basis over owned vertices. Throws NumericalError, naming the figure, where one is above 1e-11 and
/// above what rounding of K u alone explains. *Collective*.
Figures polynomial_witness(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Full& full,
                           const petsc::ConstTallRef& u, const model::Polynomial& polynomial);

/// The Taylor remainder of Eq. 17, R(p) = f(Σ p_i ψ_i + ½ Σ p_i p_j Φ_ij) − K Σ p_i ψ_i, over six halvings of p along a
/// direction in the first modes: its slope is 3 (without the Φ it is 2). Needs the derivatives of the first (at most
/// three) modes, which it solves for again. NaN where rounding hides the remainder. Throws NumericalError for a slope
/// outside [2.9, 3.1]. *Collective*.
Figures taylor_witness(const DerivativesSource& source, const std::vector<fem::StVK>& materials);

}  // namespace ritz::stages
