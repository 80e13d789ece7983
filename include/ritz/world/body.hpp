// A body that moves: its equation, its state, and room for its steps. Push it and step it.
#pragma once
#include <memory>

#include "ritz/model/model.hpp"
#include "ritz/runtime/step.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::world {

/// r, the number of reduced coordinates: of the reduction, or else of the modes.
Eigen::Index reduced_size(const model::Body& body);

/// The equation of motion of a stored body: of its polynomial where it has one, else that of small displacements over
/// its basis or its modes.
template <class Scalar = double>
runtime::Model<Scalar> make_model(const model::Body& body, const scene::Damping& damping = {});

/// The integrator of that name, or where none is asked for the one that suits the model: "exact" for oscillators, else
/// "avf".
template <class Scalar>
runtime::Integrator choose(std::optional<scene::Integrator> asked, const runtime::Model<Scalar>& model);

/// A model that instances can share.
template <class Scalar>
std::shared_ptr<const runtime::Model<Scalar>> share(runtime::Model<Scalar> model) {
  return std::make_shared<const runtime::Model<Scalar>>(std::move(model));
}

/// One of any number of bodies of a kind, which share the constant model.
template <class Scalar = double>
struct Instance {
  std::shared_ptr<const runtime::Model<Scalar>> model;
  runtime::State<Scalar> state;
  runtime::Workspace<Scalar> workspace;
  runtime::Vector<Scalar> load;  ///< Uᵀf at the end of the last step, r
  Scalar dt = 0;                 ///< s
};

/// At rest under the force `load`, r, about to make steps of `dt` seconds. Throws InputError where the integrator
/// cannot take such steps.
template <class Scalar>
Instance<Scalar> make_instance(std::shared_ptr<const runtime::Model<Scalar>> model,
                               const runtime::Integrator& integrator, std::type_identity_t<Scalar> dt,
                               runtime::VectorRef<Scalar> load);

/// One step, over which the force goes straight from the last one to `load`, r. Where it fails the state is as before.
template <class Scalar>
runtime::Outcome step(Instance<Scalar>& instance, runtime::VectorRef<Scalar> load);

}  // namespace ritz::world
