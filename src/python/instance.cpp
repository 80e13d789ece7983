#include "instance.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "equation.hpp"
#include "exchange.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/tools/run_report.hpp"
#include "ritz/world/body.hpp"
#include "ritz/world/run.hpp"

namespace ritz::python {
namespace {

constexpr py::ssize_t steps_between_looks = 256;  ///< at the clock: some of a step's own time

/// A body that moves, with what its steps cost so far.
struct Instance {
  Instance(Equation of, world::Instance<double> start) : equation(std::move(of)), moving(std::move(start)) {}

  Equation equation;
  world::Instance<double> moving;
  std::int64_t steps = 0, iterations = 0, rejected = 0;
  double work = 0, dissipated = 0;
  std::atomic_flag taken;  ///< by a call that reads or changes the state

  double t() const { return static_cast<double>(steps) * moving.dt; }
};

/// Takes an instance for one call; a second one at the same time is refused.
class Taken {
 public:
  explicit Taken(Instance& instance) : instance_(&instance) {
    if (!instance.taken.test_and_set(std::memory_order_acquire)) return;
    instance_ = nullptr;
    throw InputError("an instance is used twice at the same time: give each thread, and each place of a list, its own");
  }
  ~Taken() {
    if (instance_) instance_->taken.clear(std::memory_order_release);
  }
  Taken(Taken&& other) noexcept : instance_(std::exchange(other.instance_, nullptr)) {}
  Taken& operator=(Taken&&) = delete;

 private:
  Instance* instance_;
};

[[noreturn]] void fail(const Instance& instance, runtime::Status status) {
  const auto step = instance.steps + 1;
  const double dt = instance.moving.dt, t = static_cast<double>(step) * dt;
  world::RunResult result;
  result.integrator = instance.moving.workspace.integrator.name;
  result.failure = {
      .cause = status == runtime::Status::not_converged ? world::Cause::not_converged : world::Cause::not_finite,
      .step = step,
      .t = t,
      .pushed = {}};
  tools::fail(result, subject(instance.equation, scene::Time{.step = dt, .end = t, .integrator = {}}));
}

/// Makes one step, without Python.
void advance(Instance& instance, runtime::VectorRef<double> load) {
  const auto outcome = world::step<double>(instance.moving, load);
  if (outcome.status != runtime::Status::done) fail(instance, outcome.status);
  ++instance.steps;
  instance.iterations += outcome.iterations;
  instance.rejected += outcome.rejected;
  instance.work += outcome.work;
  instance.dissipated += outcome.dissipated;
}

runtime::Integrator integrator_of(const std::optional<std::string>& name, const runtime::Model<double>& model) {
  if (!name) return world::choose({}, model);
  const auto at = std::ranges::find(scene::integrator_names, *name);
  if (at == scene::integrator_names.end())
    throw InputError("unknown integrator '" + printable(*name) + "'" + hint(*name, scene::integrator_names));
  return world::choose(static_cast<scene::Integrator>(at - scene::integrator_names.begin()), model);
}

std::unique_ptr<Instance> make_instance(const Equation& equation, double dt,
                                        const std::optional<std::string>& integrator, const py::object& load,
                                        const py::object& z, const py::object& velocity) {
  const auto given = [&](const py::object& argument, const char* name) -> Eigen::VectorXd {
    if (argument.is_none()) return Eigen::VectorXd::Zero(equation.r());
    return vector(coordinates(argument, name, equation.r()));
  };
  const Eigen::VectorXd force = given(load, "load"), at = given(z, "z"), speed = given(velocity, "velocity");
  if (!force.allFinite() || !at.allFinite() || !speed.allFinite())
    throw InputError("load, z and velocity must be finite");
  const auto method = integrator_of(integrator, *equation.model);
  auto made = std::make_unique<Instance>(equation, world::make_instance<double>(equation.model, method, dt, force));
  made->moving.state = runtime::make_state<double>(*equation.model, method, at, speed, force);
  return made;
}

std::unique_ptr<Instance> copy(Instance& other) {
  const Taken taken(other);
  auto made = std::make_unique<Instance>(other.equation, other.moving);
  made->steps = other.steps;
  made->iterations = other.iterations;
  made->rejected = other.rejected;
  made->work = other.work;
  made->dissipated = other.dissipated;
  return made;
}

void step(Instance& instance, py::handle given) {
  const Taken taken(instance);
  if (given.is_none()) {
    const py::gil_scoped_release released;
    return advance(instance, Eigen::VectorXd(instance.moving.load));
  }
  const auto load = coordinates(given, "load", instance.equation.r());
  const py::gil_scoped_release released;
  advance(instance, vector(load));
}

py::array_t<double> steps(Instance& instance, py::handle given) {
  const Taken taken(instance);
  const auto r = instance.equation.r();
  const auto loads = numbers(given, "loads", {-1, r}, "the loads at the ends of the steps");
  const auto count = loads.shape(0);
  py::array_t<double> states(Shape{count, r});
  double* to = states.mutable_data();
  const double* from = loads.data();
  Interruptions interruptions;
  const py::gil_scoped_release released;
  for (py::ssize_t n = 0; n < count; ++n, from += r, to += r) {
    if (n % steps_between_looks == 0) interruptions.look();
    advance(instance, Eigen::Map<const Eigen::VectorXd>(from, r));
    Eigen::Map<Eigen::VectorXd>(to, r) = instance.moving.state.z();
  }
  return states;
}

void step_all(const py::sequence& given, const py::sequence& given_loads) {
  if (given.size() != given_loads.size())
    throw InputError(std::to_string(given.size()) + " instances are given " + std::to_string(given_loads.size()) +
                     " loads: give each of them one");
  struct Turn {
    py::object held;  // another thread may change the list meanwhile
    Instance& instance;
    Taken taken;
    Numbers load;
  };
  std::vector<Turn> turns;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const py::object held = given[i];
    auto& instance = held.cast<Instance&>();
    turns.push_back({.held = held,
                     .instance = instance,
                     .taken = Taken(instance),
                     .load = coordinates(py::object(given_loads[i]), "a load", instance.equation.r())});
  }
  const py::gil_scoped_release released;
  for (auto& turn : turns) advance(turn.instance, vector(turn.load));
}

double energy(Instance& instance) {
  const Taken taken(instance);
  auto room = runtime::make_evaluation(instance.moving.model->force);
  return runtime::energy(*instance.moving.model, instance.moving.state, room);
}

/// Reads something of an instance that no other call is changing.
template <class Read>
auto alone(const Read& read) {
  return [read](Instance& instance) {
    const Taken taken(instance);
    return read(instance);
  };
}

}  // namespace

void define_instance(py::module_& module) {
  py::class_<Instance>(module, "Instance",
                       "A body that moves. Each thread needs instances of its own: one that is used twice at the same\n"
                       "time raises InputError.")
      .def(
          "step", &step, py::arg("load") = py::none(),
          "One step, over which the load changes linearly from that of the last step to this one, (r,), N/sqrt(kg);\n"
          "without one it stays. Other Python threads run meanwhile. Raises NumericalError where neither the step nor\n"
          "its halves converge; the state is then what it was.")
      .def("steps", &steps, py::arg("loads"),
           "A step for each row of `loads`, (steps, r), the loads at the ends of the steps. Returns z after each,\n"
           "(steps, r). Where one raises NumericalError, or Ctrl-C ends them, those before it were made.")
      .def("copy", &copy, "Another instance in the same state.")
      .def("__copy__", &copy)
      .def_property_readonly("z", alone([](const Instance& i) { return copied(i.moving.state.z()); }),
                             "reduced coordinates, (r,), sqrt(kg) m; a new array. Displacements are body.U @ z")
      .def_property_readonly("velocity", alone([](const Instance& i) { return copied(i.moving.state.velocity()); }),
                             "z', (r,), sqrt(kg) m/s; a new array")
      .def_property_readonly("load", alone([](const Instance& i) { return copied(i.moving.load); }),
                             "at the end of the last step, (r,), N/sqrt(kg); a new array")
      .def_property_readonly("t", alone([](const Instance& i) { return i.t(); }), "s since the start")
      .def_property_readonly(
          "dt", [](const Instance& i) { return i.moving.dt; }, "the step, s")
      .def_property_readonly(
          "integrator", [](const Instance& i) { return std::string(i.moving.workspace.integrator.name); },
          "one of ritz.integrators")
      .def_property_readonly("energy", &energy, "kinetic and elastic, J")
      .def_property_readonly("work", alone([](const Instance& i) { return i.work; }),
                             "that the loads did, J; nan for linear models")
      .def_property_readonly("dissipated", alone([](const Instance& i) { return i.dissipated; }),
                             "by damping, J; nan where `work` is")
      .def_property_readonly("iterations", alone([](const Instance& i) { return i.iterations; }),
                             "of Newton's method, in all steps")
      .def_property_readonly("rejected", alone([](const Instance& i) { return i.rejected; }),
                             "attempts that did not converge and were halved, in all steps");
  module.def("step", &step_all, py::arg("instances"), py::arg("loads"),
             "One step of each instance, as its `step`; `loads`: an array (r,) for each. Where one raises\n"
             "NumericalError, those before it have made their step.");
  py::class_<Equation> equation = module.attr("Equation");
  equation.def(
      "instance", &make_instance, py::arg("dt"), py::arg("integrator") = py::none(), py::arg("load") = py::none(),
      py::arg("z") = py::none(), py::arg("velocity") = py::none(),
      "A body that moves in steps of dt seconds by this equation. `integrator` is one of ritz.integrators; by\n"
      "default 'exact' for linear models, else 'avf', which keeps the energy. It starts at z with z' = velocity\n"
      "under this load, (r,) each; 0 where they are not given.");
  py::tuple names(scene::integrator_names.size());
  for (std::size_t i = 0; i < scene::integrator_names.size(); ++i)
    names[i] = py::str(std::string(scene::integrator_names[i]));
  module.attr("integrators") = names;
}

}  // namespace ritz::python
