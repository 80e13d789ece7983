#include "nonlinear_family.hpp"

namespace ritz::runtime {
namespace {

constexpr NewmarkFamily method = chung_hulbert(0.8);

template <class Scalar>
void equation(const NonlinearModel<Scalar>& model, const NonlinearState<Scalar>& state,
              const NonlinearLoad<Scalar>& load, Scalar dt, StepEquation<Scalar>& equation) {
  family_equation(method, model, state, load, dt, equation);
}

template <class Scalar>
void advance(const Vector<Scalar>& delta, Scalar dt, NonlinearState<Scalar>& state) {
  family_advance(method, delta, dt, state);
}

}  // namespace

template <class Scalar>
Method<Scalar> nonlinear_generalized_alpha() {
  return {"generalized-alpha", History::acceleration, ForceRule::at_point, equation<Scalar>, advance<Scalar>};
}

template Method<double> nonlinear_generalized_alpha();
template Method<float> nonlinear_generalized_alpha();

}  // namespace ritz::runtime
