#include "ritz/runtime/statics.hpp"

#include <cmath>
#include <string>

#include "ritz/base/error.hpp"

namespace ritz::runtime {

Eigen::VectorXd solve_static(const Oscillators& model, const Eigen::VectorXd& load) {
  const double scale = load.size() == 0 ? 0 : load.cwiseAbs().maxCoeff();
  Eigen::VectorXd z = Eigen::VectorXd::Zero(load.size());
  for (Eigen::Index i = 0; i < load.size(); ++i) {
    if (model.stiffness[i] > 0) z[i] = load[i] / model.stiffness[i];
    else if (std::abs(load[i]) > 1e-8 * scale)
      throw InputError("the body is free: the load pushes its rigid mode " + std::to_string(i + 1) +
                       ", so it has no state of rest; fix the body when reducing it, or use [time]");
  }
  return z;
}

}  // namespace ritz::runtime
