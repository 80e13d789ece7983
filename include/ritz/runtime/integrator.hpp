// What an integrator of a linear model is. One step of one oscillator is a small affine map of its history
// y = [z, z', ...], whose coefficients depend on λ, d and the step alone: they are tabulated once, and a step is
// then O(r), exact in its cost and free of allocation. A new integrator is one function that returns these numbers.
#pragma once
#include <Eigen/Core>
#include <string_view>

namespace ritz::runtime {

inline constexpr int max_history = 4;

/// y_{n+1} = A y_n + b f_n + c f_{n+1} of one oscillator; rows and columns past the integrator's history are zero.
struct ModeStep {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  Eigen::Vector4d c = Eigen::Vector4d::Zero();
};

/// The step of the oscillator z'' + damping z' + stiffness z = f over `dt` seconds.
using StepRule = ModeStep (*)(double stiffness, double damping, double dt);

/// What the numbers of an oscillator's history are, after z and z'.
enum class History : unsigned char {
  none,          ///< y = [z, z']
  acceleration,  ///< y = [z, z', z'']
  last_step      ///< y = [z, z', z of the step before, z' of the step before]
};

constexpr int history_size(History history) {
  switch (history) {
    case History::none: return 2;
    case History::acceleration: return 3;
    case History::last_step: return 4;
  }
  return 0;
}

struct Integrator {
  std::string_view name;
  History history;
  StepRule step;
  StepRule start;  ///< the first step, and the first after a change of its length; the same as `step` for most
};

}  // namespace ritz::runtime
