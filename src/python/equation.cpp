#include "equation.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <vector>

#include "exchange.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/runtime/statics.hpp"
#include "ritz/tools/run_report.hpp"
#include "ritz/world/body.hpp"
#include "ritz/world/rigid_motions.hpp"
#include "ritz/world/run.hpp"

namespace ritz::python {
namespace {

using Evaluation = runtime::Evaluation<double>;

double not_negative(double value, const char* name) {
  if (std::isfinite(value) && value >= 0) return value;
  throw InputError(std::string(name) + " is " + shown(value) + ", and must be a number that is not negative");
}

Equation make_equation(const LoadedBody& body, double alpha, double beta,
                       const std::variant<double, std::vector<double>>& ratio) {
  scene::Damping damping{.alpha = not_negative(alpha, "alpha"), .beta = not_negative(beta, "beta")};
  if (const auto* one = std::get_if<double>(&ratio); one && *one != 0) damping.ratio = {*one};
  if (const auto* several = std::get_if<std::vector<double>>(&ratio)) damping.ratio = *several;
  for (const double value : damping.ratio) not_negative(value, "ratio");
  if (const auto text = tools::overdamped(damping); !text.empty()) warn(text);
  if (world::lacks_motions(*body.value))
    warn("the basis of " + body.file.string() +
         " may leave out rigid motions of its body, which is free: under loads that are not in equilibrium it neither "
         "falls nor flies");
  return {body, world::share(world::make_model<double>(*body.value, damping))};
}

/// Evaluates at z, without the GIL.
Evaluation evaluate(const Equation& equation, py::handle given) {
  const auto z = coordinates(given, "z", equation.r());
  const py::gil_scoped_release released;
  auto result = runtime::make_evaluation(equation.model->force);
  runtime::evaluate<double>(equation.model->force, vector(z), result);
  return result;
}

py::array_t<double> equilibrium(const Equation& equation, py::handle given, int steps) {
  const auto load = coordinates(given, "load", equation.r());
  if (!vector(load).allFinite()) throw InputError("load must be finite");
  if (steps < 1) throw InputError("steps is " + std::to_string(steps) + ", and must be at least 1");
  Eigen::VectorXd z = Eigen::VectorXd::Zero(equation.r());
  {
    const py::gil_scoped_release released;
    auto workspace = runtime::make_static_workspace<double>(*equation.model);
    for (int n = 1; n <= steps; ++n) {
      const double before = double(n - 1) / steps, t = double(n) / steps;
      const Eigen::VectorXd begin = before * vector(load), end = t * vector(load);
      const auto outcome = runtime::solve_static<double>(*equation.model, {begin, end}, z, workspace);
      if (!outcome.failure && z.allFinite()) continue;
      world::RunResult result;
      result.failure = {.cause = outcome.failure ? world::cause_of(*outcome.failure) : world::Cause::not_finite,
                        .step = n,
                        .t = before + outcome.reached * (t - before),
                        .softest = outcome.softest,
                        .softest_at_rest = workspace.softest_at_rest,
                        .pushed = {}};
      if (runtime::is_oscillators(*equation.model)) result.failure->pushed = outcome.pushed;
      tools::fail(result, subject(equation, scene::Static{steps}));
    }
  }
  return copied(z);
}

}  // namespace

tools::RunBody subject(const Equation& equation, const std::variant<scene::Time, scene::Static>& analysis) {
  const scene::Scene scene{.analysis = analysis, .damping = {}, .gravity = {}, .shake = {}, .loads = {}, .probes = {}};
  return {
      .name = {}, .model_file = equation.body.file, .scene = scene, .model = equation.body.value, .coordinates = {}};
}

void define_equation(py::module_& module) {
  py::class_<Equation>(module, "Equation",
                       "The equation of motion z'' + D z' + f(z) = load of a body, in r reduced coordinates: z in\n"
                       "sqrt(kg) m, loads and f in N/sqrt(kg). Constant; threads can share it.")
      .def_property_readonly("r", &Equation::r, "the number of reduced coordinates")
      .def_property_readonly(
          "body", [](const Equation& equation) { return equation.body; }, "the body it is of")
      .def(
          "energy", [](const Equation& equation, py::handle z) { return evaluate(equation, z).energy; }, py::arg("z"),
          "The elastic energy E(z), J; z: (r,)")
      .def(
          "force", [](const Equation& equation, py::handle z) { return copied(evaluate(equation, z).force); },
          py::arg("z"), "The internal force f = dE/dz, (r,), N/sqrt(kg); z: (r,)")
      .def(
          "tangent", [](const Equation& equation, py::handle z) { return copied(evaluate(equation, z).tangent); },
          py::arg("z"), "The tangent stiffness K = df/dz, (r, r), 1/s2; z: (r,)")
      .def(
          "evaluate",
          [](const Equation& equation, py::handle z) {
            const auto at = evaluate(equation, z);
            return py::make_tuple(at.energy, copied(at.force), copied(at.tangent));
          },
          py::arg("z"), "Energy, force and tangent at z, for the cost of one of them")
      .def("equilibrium", &equilibrium, py::arg("load"), py::arg("steps") = 1,
           "z at rest under a load, (r,), that grows from nothing in so many increments, from rest at 0. Raises\n"
           "NumericalError where the body snaps or buckles on the way, and InputError for a body that nothing holds.");
  py::class_<LoadedBody> body = module.attr("Body");
  body.def(
      "equation", &make_equation, py::arg("alpha") = 0., py::arg("beta") = 0., py::arg("ratio") = 0.,
      "The equation of motion, with D = alpha M + beta K and 2 ratio omega added to each mode: alpha in 1/s, beta\n"
      "in s, ratio a fraction of the critical damping, one number or one for each flexible mode, the last one for\n"
      "all others. Of the polynomial where the body has one, else of small displacements.");
}

}  // namespace ritz::python
