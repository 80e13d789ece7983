// The Python module `ritz`.
#include <pybind11/pybind11.h>

#include "body.hpp"
#include "equation.hpp"
#include "instance.hpp"
#include "parts.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/base/program.hpp"
#include "run.hpp"

PYBIND11_MODULE(ritz, module) {
  namespace py = pybind11;
  using namespace ritz;
  module.doc() =
      "Reduced models of deformable solids: read, evaluated, stepped and loaded, with NumPy arrays. SI units.\n\n"
      "    body = ritz.read('model.h5')\n"
      "    tip = body.unit_force('tip')\n"
      "    moving = body.equation(alpha=0.5).instance(dt=1e-3)\n"
      "    moving.step(tip @ [0, 0, -1])\n"
      "    print(tip.T @ moving.z)";
  module.attr("__version__") = version;
  // Python's own message is what the programs print.
  static py::exception<InputError> input_error(module, "InputError", PyExc_ValueError);
  static py::exception<NumericalError> numerical_error(module, "NumericalError", PyExc_ArithmeticError);
  input_error.attr("__doc__") = "The input is wrong; one sentence says what, where, and what to do.";
  numerical_error.attr("__doc__") = "The computation failed; one sentence says where.";
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      input_error(printable(error.what()).c_str());
    } catch (const NumericalError& error) {
      numerical_error(printable(error.what()).c_str());
    }
  });
  python::define_parts(module);
  python::define_body(module);
  python::define_equation(module);
  python::define_instance(module);
  python::define_run(module);
}
