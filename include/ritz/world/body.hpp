// A body that moves: its equation of motion, its state, and the workspace of its steps.
#pragma once
#include <memory>

#include "ritz/model/model.hpp"
#include "ritz/runtime/step.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::world {

/// The number r of reduced coordinates: those of the reduction, or without one the number of modes.
Eigen::Index reduced_size(const model::Body& body);

/// The equation of motion of a stored body: that of its cubature or its polynomial if it has one, else the linear one
/// (small displacements) of its reduction or its modes. Throws InputError as runtime::make_model does.
template <class Scalar = double>
runtime::Model<Scalar> make_model(const model::Body& body, const scene::Damping& damping = {});

/// The integrator of that name; if none is asked for, "exact" for oscillators and "avf" for all other models.
template <class Scalar>
runtime::Integrator choose(std::optional<scene::Integrator> asked, const runtime::Model<Scalar>& model);

/// Makes a model that instances can share.
template <class Scalar>
std::shared_ptr<const runtime::Model<Scalar>> share(runtime::Model<Scalar> model) {
  return std::make_shared<const runtime::Model<Scalar>>(std::move(model));
}

/// One of any number of bodies of one kind: they share the constant model, and each has its own state.
template <class Scalar = double>
struct Instance {
  std::shared_ptr<const runtime::Model<Scalar>> model;
  runtime::State<Scalar> state;
  runtime::Workspace<Scalar> workspace;
  runtime::Vector<Scalar> load;  ///< Uᵀf at the end of the last step, r numbers, N/√kg
  Scalar dt = 0;                 ///< step length, s
};

/// An instance with the given z and z' under the load `load`, r numbers each, for steps of `dt` seconds. Throws
/// InputError when the integrator cannot take such steps (see runtime::make_workspace).
template <class Scalar>
Instance<Scalar> make_instance(std::shared_ptr<const runtime::Model<Scalar>> model,
                               const runtime::Integrator& integrator, std::type_identity_t<Scalar> dt,
                               runtime::VectorRef<Scalar> z, runtime::VectorRef<Scalar> velocity,
                               runtime::VectorRef<Scalar> load);
/// The same at rest: z = z' = 0.
template <class Scalar>
Instance<Scalar> make_instance(std::shared_ptr<const runtime::Model<Scalar>> model,
                               const runtime::Integrator& integrator, std::type_identity_t<Scalar> dt,
                               runtime::VectorRef<Scalar> load);

/// Makes one step, over which the load changes linearly from that of the last step to `load`, r numbers. On failure the
/// state and the load are left as they were.
template <class Scalar>
runtime::Outcome step(Instance<Scalar>& instance, runtime::VectorRef<Scalar> load);

}  // namespace ritz::world
