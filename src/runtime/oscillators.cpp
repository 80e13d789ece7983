#include "ritz/runtime/oscillators.hpp"

#include <algorithm>
#include <cmath>

#include "rigid_stiffness.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"

namespace ritz::runtime {

Oscillators make_oscillators(const model::Modes& modes, const Damping& damping) {
  const Eigen::Index r = modes.eigenvalues.size();
  Oscillators oscillators{.stiffness = Eigen::ArrayXd::Zero(r), .damping = Eigen::ArrayXd::Constant(r, damping.alpha)};
  std::size_t flexible = 0;
  for (Eigen::Index i = 0; i < r; ++i) {
    if (modes.kinds[static_cast<std::size_t>(i)] == model::ModeKind::rigid) continue;
    const double lambda = modes.eigenvalues[i];
    if (!(lambda >= 0))
      throw InputError("mode " + std::to_string(i + 1) + " of the model has the eigenvalue " + shown(lambda) +
                       " rad²/s², which is not a vibration: reduce the model again");
    const auto& zeta = damping.ratio;
    const double ratio = zeta.empty() ? 0 : zeta[std::min(flexible++, zeta.size() - 1)];
    oscillators.stiffness[i] = lambda;
    oscillators.damping[i] += damping.beta * lambda + 2 * ratio * std::sqrt(lambda);
  }
  return oscillators;
}

Oscillators make_oscillators(const model::Reduction& reduction, const Damping& damping) {
  const Eigen::ArrayXd& stiffness = reduction.stiffness.array();
  const double softest = rigid_stiffness * stiffness.maxCoeff();
  model::Modes modes;
  modes.eigenvalues = (stiffness > softest).select(stiffness, 0);
  for (const double value : modes.eigenvalues)
    modes.kinds.push_back(value > 0 ? model::ModeKind::flexible : model::ModeKind::rigid);
  return make_oscillators(modes, damping);
}

double energy(const Oscillators& model, Eigen::Ref<const Eigen::VectorXd> z,
              Eigen::Ref<const Eigen::VectorXd> velocity) {
  return 0.5 * (velocity.squaredNorm() + (model.stiffness * z.array().square()).sum());
}

}  // namespace ritz::runtime
