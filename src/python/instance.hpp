// Bodies that move step by step, in Python.
#pragma once
#include <pybind11/pybind11.h>

namespace ritz::python {

/// Defines Instance, how an Equation makes one, `step` of several, and `integrators`. To be called after
/// define_equation.
void define_instance(pybind11::module_& module);

}  // namespace ritz::python
