#include "nonlinear_family.hpp"

namespace ritz::runtime {
namespace {

constexpr NewmarkFamily average_acceleration{.beta = 0.25, .gamma = 0.5};

template <class Scalar>
void equation(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state,
              const NonlinearLoad<Scalar>& load, Scalar dt, StepEquation<Scalar>& equation) {
  family_equation(average_acceleration, model, state, load, dt, equation);
}

template <class Scalar>
void advance(const Vector<Scalar>& delta, Scalar dt, NonlinearState<Scalar>& state) {
  family_advance(average_acceleration, delta, dt, state);
}

}  // namespace

template <class Scalar>
Method<Scalar> nonlinear_newmark() {
  return {"newmark", History::acceleration, ForceRule::at_point, equation<Scalar>, advance<Scalar>};
}

template Method<double> nonlinear_newmark();
template Method<float> nonlinear_newmark();

}  // namespace ritz::runtime
