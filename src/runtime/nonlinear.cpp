#include "ritz/runtime/nonlinear.hpp"

#include <algorithm>
#include <cmath>

#include "rigid_stiffness.hpp"

namespace ritz::runtime {
template <class Scalar>
NonlinearModel<Scalar> make_nonlinear_model(const model::Polynomial& polynomial, const Damping& damping) {
  NonlinearModel<Scalar> model{.forces = make_forces<Scalar>(polynomial), .damping = {}};
  const Eigen::MatrixXd rest = model.forces.linear.template cast<double>();
  Eigen::MatrixXd D = damping.beta * rest;
  std::size_t flexible = 0;
  const double softest = rigid_stiffness * rest.diagonal().maxCoeff();
  for (Eigen::Index i = 0; i < model.size(); ++i) {
    D(i, i) += damping.alpha;
    const auto& zeta = damping.ratio;
    if (rest(i, i) <= softest || zeta.empty()) continue;
    D(i, i) += 2 * zeta[std::min(flexible++, zeta.size() - 1)] * std::sqrt(rest(i, i));
  }
  model.damping = D.cast<Scalar>();
  return model;
}

template <class Scalar>
NonlinearState<Scalar> make_state(const NonlinearModel<Scalar>& model, History history, VectorRef<Scalar> z,
                                  VectorRef<Scalar> velocity, VectorRef<Scalar> load) {
  NonlinearState<Scalar> state;
  state.history.setZero(model.size(), history_size(history));
  state.history.col(0) = z;
  state.history.col(1) = velocity;
  if (history == History::acceleration) {
    auto at = make_evaluation(model.forces);
    evaluate<Scalar>(model.forces, z, at);
    state.history.col(2) = load - model.damping * velocity - at.force;
  }
  return state;
}

template <class Scalar>
Scalar energy(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state, Evaluation<Scalar>& room) {
  evaluate<Scalar>(model.forces, state.z(), room);
  return state.velocity().squaredNorm() / 2 + room.energy;
}

#define RITZ_INSTANCE(S)                                                                                              \
  template NonlinearModel<S> make_nonlinear_model(const model::Polynomial&, const Damping&);                          \
  template NonlinearState<S> make_state(const NonlinearModel<S>&, History, VectorRef<S>, VectorRef<S>, VectorRef<S>); \
  template S energy(const NonlinearModel<S>&, const NonlinearState<S>&, Evaluation<S>&);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::runtime
