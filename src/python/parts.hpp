// The parts of a body, in Python.
#pragma once
#include <pybind11/pybind11.h>

namespace ritz::python {

/// Defines Modes, Reduction, Polynomial, Inertia and Report. Python holds a part as what its arrays keep alive.
void define_parts(pybind11::module_& module);

}  // namespace ritz::python
