#include "ritz/world/body.hpp"

#include <stdexcept>

namespace ritz::world {

Eigen::Index reduced_size(const model::Body& body) {
  return body.reduction ? body.reduction->stiffness.size() : body.modes->eigenvalues.size();
}

template <class Scalar>
runtime::Model<Scalar> make_model(const model::Body& body, const scene::Damping& damping) {
  const auto& [alpha, beta, ratio] = damping;
  const runtime::Damping damped{.alpha = alpha, .beta = beta, .ratio = ratio};
  if (body.cubature)
    return runtime::make_model<Scalar>(*body.cubature, body.geometry.materials,
                                       body.polynomial ? &*body.polynomial : nullptr, damped);
  if (body.polynomial) return runtime::make_model<Scalar>(*body.polynomial, damped);
  return body.reduction ? runtime::make_model<Scalar>(*body.reduction, damped)
                        : runtime::make_model<Scalar>(*body.modes, damped);
}

template <class Scalar>
runtime::Integrator choose(std::optional<scene::Integrator> asked, const runtime::Model<Scalar>& model) {
  switch (asked.value_or(runtime::is_oscillators(model) ? scene::Integrator::exact : scene::Integrator::avf)) {
    case scene::Integrator::exact: return runtime::exact();
    case scene::Integrator::implicit_euler: return runtime::implicit_euler();
    case scene::Integrator::newmark: return runtime::newmark();
    case scene::Integrator::generalized_alpha: return runtime::generalized_alpha();
    case scene::Integrator::bdf2: return runtime::bdf2();
    case scene::Integrator::central_difference: return runtime::central_difference();
    case scene::Integrator::avf: return runtime::avf();
    case scene::Integrator::linearly_implicit: return runtime::linearly_implicit();
  }
  throw std::logic_error("an integrator without a name");
}

template <class Scalar>
Instance<Scalar> make_instance(std::shared_ptr<const runtime::Model<Scalar>> model,
                               const runtime::Integrator& integrator, std::type_identity_t<Scalar> dt,
                               runtime::VectorRef<Scalar> load) {
  const runtime::Vector<Scalar> rest = runtime::Vector<Scalar>::Zero(model->size());
  return make_instance<Scalar>(std::move(model), integrator, dt, rest, rest, load);
}

template <class Scalar>
Instance<Scalar> make_instance(std::shared_ptr<const runtime::Model<Scalar>> model,
                               const runtime::Integrator& integrator, std::type_identity_t<Scalar> dt,
                               runtime::VectorRef<Scalar> z, runtime::VectorRef<Scalar> velocity,
                               runtime::VectorRef<Scalar> load) {
  auto state = runtime::make_state<Scalar>(*model, integrator, z, velocity, load);
  auto workspace = runtime::make_workspace<Scalar>(*model, integrator, dt);
  return {std::move(model), std::move(state), std::move(workspace), load, dt};
}

template <class Scalar>
runtime::Outcome step(Instance<Scalar>& instance, runtime::VectorRef<Scalar> load) {
  const auto outcome =
      runtime::step<Scalar>(*instance.model, instance.state, {instance.load, load}, instance.dt, instance.workspace);
  if (outcome.status == runtime::Status::done) instance.load = load;
  return outcome;
}

#define RITZ_INSTANCE(S)                                                                                      \
  template runtime::Model<S> make_model(const model::Body&, const scene::Damping&);                           \
  template runtime::Integrator choose(std::optional<scene::Integrator>, const runtime::Model<S>&);            \
  template Instance<S> make_instance(std::shared_ptr<const runtime::Model<S>>, const runtime::Integrator&, S, \
                                     runtime::VectorRef<S>, runtime::VectorRef<S>, runtime::VectorRef<S>);    \
  template Instance<S> make_instance(std::shared_ptr<const runtime::Model<S>>, const runtime::Integrator&, S, \
                                     runtime::VectorRef<S>);                                                  \
  template runtime::Outcome step(Instance<S>&, runtime::VectorRef<S>);
RITZ_INSTANCE(double)
RITZ_INSTANCE(float)
#undef RITZ_INSTANCE

}  // namespace ritz::world
