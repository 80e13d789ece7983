// Whole scenes, in Python.
#pragma once
#include <pybind11/pybind11.h>

namespace ritz::python {

/// Defines Run, BodyRun, EnergyBalance and `run`. To be called after define_body.
void define_run(pybind11::module_& module);

}  // namespace ritz::python
