// A body of a model file, in Python.
#pragma once
#include <pybind11/pybind11.h>

#include <filesystem>
#include <memory>

#include "ritz/model/model.hpp"

namespace ritz::python {

/// A body, which is not changed after it was read, and the file that it is from.
struct LoadedBody {
  std::shared_ptr<const model::Body> value;
  std::filesystem::path file;
};

/// Defines Body, `read` and `bodies`. To be called after define_parts.
void define_body(pybind11::module_& module);

}  // namespace ritz::python
