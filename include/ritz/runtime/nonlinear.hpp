// The nonlinear reduced model z'' + D z' + f̃(z) = Uᵀf (the mass is the identity) and its state.
#pragma once
#include "ritz/runtime/forces.hpp"
#include "ritz/runtime/integrator.hpp"
#include "ritz/runtime/oscillators.hpp"

namespace ritz::runtime {

/// Constant while it runs; shared by any number of bodies of one kind.
template <class Scalar>
struct NonlinearModel {
  Forces<Scalar> forces;
  Matrix<Scalar> damping;  ///< D = α I + β K̃(0) + diag(2 ζ_i ω_i), r x r, 1/s

  Eigen::Index size() const { return forces.r; }
};

/// ω_i² is K̃(0)_ii, which is diagonal in a reduced basis; ζ counts the coordinates that have any stiffness. Throws
/// InputError as make_forces.
template <class Scalar>
NonlinearModel<Scalar> make_nonlinear_model(const model::Polynomial& polynomial, const Damping& damping);

/// Everything the next step depends on: store it and go on later, to the last bit.
template <class Scalar>
struct NonlinearState {
  Matrix<Scalar> history;  ///< r x history_size: columns z, z', then the method's own
  Scalar last_dt = 0;      ///< length of the last step (or of its last part) s; 0 at the start

  auto z() const { return history.col(0); }
  auto velocity() const { return history.col(1); }
};

/// The state with given z and z' under the force `load`; its acceleration is load - D z' - f̃(z).
template <class Scalar>
NonlinearState<Scalar> make_state(const NonlinearModel<Scalar>& model, History history, VectorRef<Scalar> z,
                                  VectorRef<Scalar> velocity, VectorRef<Scalar> load);

/// ½ ‖z'‖² + Ẽ(z), J. Does not allocate; `room` is overwritten.
template <class Scalar>
Scalar energy(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state, Evaluation<Scalar>& room);

}  // namespace ritz::runtime
