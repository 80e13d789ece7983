// The equation of motion of a body, in Python: forces and states of rest.
#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <variant>

#include "body.hpp"
#include "ritz/runtime/model.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/tools/run_body.hpp"

namespace ritz::python {

/// The equation of motion of a body, with its damping. Constant: any number of threads can share it.
struct Equation {
  LoadedBody body;
  std::shared_ptr<const runtime::Model<double>> model;

  Eigen::Index r() const { return model->size(); }
};

/// What sentences about a motion or a state of rest that failed are made from.
tools::RunBody subject(const Equation& equation, const std::variant<scene::Time, scene::Static>& analysis);

/// Defines Equation, and how a Body makes one. To be called after define_body.
void define_equation(pybind11::module_& module);

}  // namespace ritz::python
