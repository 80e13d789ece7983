// The linear reduced model at rest under a load.
#pragma once
#include <Eigen/Core>

#include "ritz/runtime/oscillators.hpp"

namespace ritz::runtime {

/// z = K̃⁻¹ f, z_i = f_i / λ_i. A rigid mode (λ = 0) stays 0; throws InputError when the load pushes one, by more than
/// 1e-8 of the largest |f_i|.
Eigen::VectorXd solve_static(const Oscillators& model, const Eigen::VectorXd& load);

}  // namespace ritz::runtime
