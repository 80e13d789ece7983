// The linear reduced model as the runtime sees it: r independent damped oscillators, Eq. 3.
#pragma once
#include <Eigen/Core>
#include <span>

#include "ritz/model/model.hpp"

namespace ritz::runtime {

/// z_i'' + d_i z_i' + λ_i z_i = f_i(t), i = 0 ... r-1; λ_i and d_i are not negative.
struct Oscillators {
  Eigen::ArrayXd stiffness;  ///< λ, rad²/s²; exactly 0 for a rigid mode
  Eigen::ArrayXd damping;    ///< d, 1/s

  Eigen::Index size() const { return stiffness.size(); }
};

/// How the modes are damped; the three sum up.
struct Damping {
  double alpha = 0;               ///< 1/s, D = αM + βK
  double beta = 0;                ///< s
  std::span<const double> ratio;  ///< ζ of each flexible mode, the last one held; empty: none
};

/// d_i = α + β λ_i + 2 ζ_i ω_i; a rigid mode has λ = 0 and d = α. Throws InputError for an eigenvalue that is negative.
Oscillators make_oscillators(const model::Modes& modes, const Damping& damping);

/// The same over a basis that is not of modes: ω_i² is the diagonal of UᵀKU, and below 1e-10 of its largest 0 (rigid).
Oscillators make_oscillators(const model::Reduction& reduction, const Damping& damping);

/// ½ (‖z'‖² + Σ λ_i z_i²), J.
double energy(const Oscillators& model, Eigen::Ref<const Eigen::VectorXd> z,
              Eigen::Ref<const Eigen::VectorXd> velocity);

}  // namespace ritz::runtime
