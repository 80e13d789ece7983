#include "run.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "body.hpp"
#include "exchange.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/format/library.hpp"
#include "ritz/runtime/reconstruction.hpp"
#include "ritz/scene_file/read.hpp"
#include "ritz/tools/play.hpp"
#include "ritz/tools/run_body.hpp"
#include "ritz/world/loads.hpp"

namespace ritz::python {
namespace {

constexpr auto of_dictionary = "the scene";  ///< what messages call it
constexpr int deepest = 8;                   ///< levels of lists and dictionaries; scenes have four

/// A value of a dictionary. `key` is the one that it stands under.
scene::Value value_of(py::handle given, const std::string& key, int level) {
  if (level > deepest) throw InputError(std::string(of_dictionary) + " is nested deeper than any scene is, at " + key);
  if (py::isinstance<py::bool_>(given)) return {given.cast<bool>()};
  if (py::isinstance<py::str>(given)) return {given.cast<std::string>()};
  if (py::isinstance<py::array>(given)) return value_of(given.attr("tolist")(), key, level);
  if (PyIndex_Check(given.ptr())) {
    const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
    if (!whole) throw py::error_already_set();
    const long long number = PyLong_AsLongLong(whole.ptr());
    if (!PyErr_Occurred()) return {std::int64_t{number}};
    PyErr_Clear();
    throw InputError(std::string(of_dictionary) + ": " + key + " is a larger whole number than fits 64 bits");
  }
  if (py::hasattr(given, "__float__")) return {given.cast<double>()};
  if (py::hasattr(given, "__fspath__")) return {given.cast<std::filesystem::path>().string()};
  if (py::isinstance<py::dict>(given)) {
    scene::Value::Table table;
    for (const auto& [name, item] : py::reinterpret_borrow<py::dict>(given)) {
      if (!py::isinstance<py::str>(name))
        throw InputError(std::string(of_dictionary) + ": a key of " + key + " is no text");
      const auto text = name.cast<std::string>();
      table.emplace_back(text, value_of(item, "'" + printable(text) + "'", level + 1));
    }
    return {table};
  }
  if (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) {
    scene::Value::Array array;
    for (const auto& item : py::reinterpret_borrow<py::sequence>(given))
      array.push_back(value_of(item, key, level + 1));
    return {array};
  }
  throw InputError(std::string(of_dictionary) + ": " + key + " is of the kind " +
                   py::str(py::type::handle_of(given).attr("__name__")).cast<std::string>() +
                   ", and must be a number, a text, a list or a dictionary");
}

/// A scene, and its file if it is of one.
struct Staged {
  scene::Scene scene;
  std::filesystem::path file = {};
};

Staged stage(const std::variant<py::dict, std::filesystem::path>& given) {
  if (const auto* file = std::get_if<std::filesystem::path>(&given)) return {scene::read(*file), *file};
  const auto value = value_of(std::get<py::dict>(given), "the dictionary", 0);
  return {scene::from_table(std::get<scene::Value::Table>(value.is), of_dictionary)};
}

using GivenModel = std::variant<std::monostate, LoadedBody, std::filesystem::path>;

/// The bodies of the scene. Those that would be read from the command line's model are the given one.
std::vector<tools::RunBody> cast(const scene::Scene& scene, const GivenModel& model) {
  const auto* path = std::get_if<std::filesystem::path>(&model);
  const auto* body = std::get_if<LoadedBody>(&model);
  auto bodies = tools::cast(scene, path ? *path : body ? body->file : std::filesystem::path());
  for (std::size_t i = 0; body && i < bodies.size(); ++i) {
    const auto* named = scene.bodies.empty() ? nullptr : &scene.bodies[i];
    if (named && !named->model.empty()) continue;
    if (named && !named->model_body.empty() && named->model_body != body->value->name)
      throw InputError("body '" + printable(named->name) + "' is to be '" + printable(named->model_body) +
                       "' of its model, and the body given is '" + printable(body->value->name) + "'");
    bodies[i].model = body->value;
  }
  return bodies;
}

/// The states of a run.
struct States {
  std::vector<double> times;
  std::vector<std::vector<double>> z;  ///< of each body, one state after the other
};

/// What came of a body.
struct BodyRun {
  tools::RunBody body;
  world::RunResult result;
  std::filesystem::path output;
  std::optional<std::int64_t> inverted_cells;
  py::array_t<double> z;
};

struct Run {
  py::array_t<double> t;
  py::dict bodies, probes;
  std::vector<std::string> warnings;
};

std::optional<std::int64_t> inverted_cells(const model::Body& body, const Eigen::Ref<const Eigen::VectorXd>& z) {
  if (body.geometry.points.rows() == 0 || body.geometry.rows == model::Rows::surface) return std::nullopt;
  model::Points u(body.geometry.points.rows(), 3);
  runtime::reconstruct(body.basis, z, u);
  return tools::inside_out(body.geometry, u);
}

/// The displacements of the probes of a body over its states, each (states, 3), as ritz-run computes them.
void read_probes(const tools::RunBody& body, const std::vector<double>& z, py::dict& probes) {
  const auto P = world::probe_matrix(body.scene, *body.model);
  const Eigen::Index r = P.cols(), states = std::ssize(z) / r;
  std::vector<std::vector<double>> u(body.scene.probes.size(),
                                     std::vector<double>(3 * static_cast<std::size_t>(states)));
  Eigen::VectorXd at(P.rows());
  for (Eigen::Index n = 0; n < states; ++n) {
    at.noalias() = P * Eigen::Map<const Eigen::VectorXd>(z.data() + n * r, r);
    for (std::size_t p = 0; p < u.size(); ++p)
      Eigen::Map<Eigen::Vector3d>(u[p].data() + 3 * n) = at.segment<3>(3 * static_cast<Eigen::Index>(p));
  }
  for (std::size_t p = 0; p < u.size(); ++p)
    probes[py::str(body.scene.probes[p].name)] = handed_over(std::move(u[p]), {states, 3});
}

Run run(const std::variant<py::dict, std::filesystem::path>& given_scene, const GivenModel& model,
        const std::optional<std::filesystem::path>& output, std::optional<std::int64_t> frames,
        std::optional<std::int64_t> every, const std::string& forces, const std::string& precision) {
  tools::RunOptions options;
  options.voice = Voice::quiet;
  options.output = output.value_or("");
  options.frames = frames;
  options.every = every;
  options.forces = static_cast<tools::Forces>(one_of({"stored", "linear"}, forces, "forces"));
  options.precision = static_cast<world::Precision>(one_of({"float64", "float32"}, precision, "precision"));
  if ((frames || every) && !output)
    throw InputError("frames and every say how much of the motion is written: give output");
  if (frames && every) throw InputError("frames and every exclude each other: keep one of them");
  if (frames.value_or(0) < 0 || every.value_or(1) < 1)
    throw InputError("frames must not be negative, and every must be at least 1");
  if (options.forces == tools::Forces::linear && std::holds_alternative<LoadedBody>(model))
    throw InputError("forces are chosen where a model is read: ritz.read(file, forces='linear')");
  const auto staged = stage(given_scene);
  options.scene = staged.file;
  auto bodies = cast(staged.scene, model);

  States states{.times = {}, .z = std::vector<std::vector<double>>(bodies.size())};
  Interruptions interruptions;
  std::vector<std::string> warnings;
  const tools::Listener listener{.warning = [&](const std::string& text) { warnings.push_back(text); },
                                 .state =
                                     [&](std::size_t body, double t, const auto& z) {
                                       if (body == 0) states.times.push_back(t);
                                       states.z[body].insert(states.z[body].end(), z.begin(), z.end());
                                       interruptions.look();
                                     }};
  auto played = [&] {
    const py::gil_scoped_release released;
    format::silence_errors();
    return tools::play(options, staged.scene, std::move(bodies), output ? tools::Files::written : tools::Files::none,
                       listener);
  }();
  for (const auto& text : warnings) warn(text);

  const auto count = std::ssize(states.times);
  Run done{.t = handed_over(std::move(states.times), {count}), .bodies = {}, .probes = {}, .warnings = warnings};
  for (std::size_t i = 0; i < played.bodies.size(); ++i) {
    auto& [body, result, written, inverted] = played.bodies[i];
    auto& z = states.z[i];
    const auto r = world::reduced_size(*body.model);
    read_probes(body, z, done.probes);
    const auto upside_down =
        inverted_cells(*body.model, Eigen::Map<const Eigen::VectorXd>(z.data() + (count - 1) * r, r));
    const auto name = body.name;
    done.bodies[py::str(name)] = py::cast(BodyRun{.body = std::move(body),
                                                  .result = std::move(result),
                                                  .output = written,
                                                  .inverted_cells = upside_down,
                                                  .z = handed_over(std::move(z), {count, r})});
  }
  return done;
}

py::object only_z(const Run& run) {
  if (run.bodies.size() == 1) return run.bodies.begin()->second.attr("z");
  throw InputError("the scene has several bodies: say run.bodies[NAME].z");
}

void define_results(py::module_& module) {
  using world::EnergyBalance;
  py::class_<EnergyBalance>(
      module, "EnergyBalance",
      "The energy E of a motion beside E0 at its start, the work W of the loads and the energy Q\n"
      "that damping dissipated; the drift is E - E0 - W + Q. All in J.")
      .def_readonly("start", &EnergyBalance::start, "E0, the energy at the start")
      .def_readonly("gained", &EnergyBalance::gained, "the largest drift above zero")
      .def_readonly("lost", &EnergyBalance::lost, "the largest drift below zero, as a positive number")
      .def_readonly("available", &EnergyBalance::available, "the largest value of E0 + W - Q and of |W - Q|")
      .def_readonly("work", &EnergyBalance::work, "W at the end")
      .def_readonly("dissipated", &EnergyBalance::dissipated, "Q at the end");
  py::class_<BodyRun>(module, "BodyRun", "What came of one body of a scene.")
      .def_readonly("z", &BodyRun::z, "its states, (states, r), sqrt(kg) m")
      .def_property_readonly(
          "integrator", [](const BodyRun& run) { return std::string(run.result.integrator); },
          "its name; '' of statics")
      .def_property_readonly(
          "steps", [](const BodyRun& run) { return run.result.steps; }, "of the scene")
      .def_property_readonly(
          "seconds", [](const BodyRun& run) { return run.result.seconds; }, "that its steps took, on the wall")
      .def_property_readonly(
          "iterations", [](const BodyRun& run) { return run.result.iterations; }, "of Newton's method, in all steps")
      .def_property_readonly(
          "rejected", [](const BodyRun& run) { return run.result.rejected; },
          "attempts that did not converge and were halved, in all steps")
      .def_property_readonly(
          "energy", [](const BodyRun& run) { return run.result.energy; }, "of nonlinear motions; else None")
      .def_readonly(
          "inverted_cells", &BodyRun::inverted_cells,
          "that are inside out at the end; None where cells are not known: of a surface alone, and with frames=0")
      .def_property_readonly(
          "output",
          [](const BodyRun& run) {
            return run.output.empty() ? std::nullopt : std::optional<std::filesystem::path>(run.output);
          },
          "the motion that was written, a Path, or None");
  py::class_<Run>(module, "Run", "What came of a scene.")
      .def_readonly("t", &Run::t, "(states,), s; of statics load fractions")
      .def_readonly("bodies", &Run::bodies, "BodyRun by name; '' in a scene that names no bodies")
      .def_readonly("probes", &Run::probes, "displacements by the names of the probes, (states, 3), m")
      .def_readonly("warnings", &Run::warnings, "each was issued as a RuntimeWarning, too")
      .def_property_readonly("z", &only_z, "the states of the only body, (states, r), sqrt(kg) m");
}

}  // namespace

void define_run(py::module_& module) {
  define_results(module);
  module.def(
      "run", &run, py::arg("scene"), py::arg("model") = py::none(), py::kw_only(), py::arg("output") = py::none(),
      py::arg("frames") = py::none(), py::arg("every") = py::none(), py::arg("forces") = "stored",
      py::arg("precision") = "float64",
      "Runs a scene as ritz-run does: to the same numbers and with the same checks and sentences. `scene` is a TOML\n"
      "file, or a dictionary with its keys; `model` a file or a Body, where the scene names none. With `output` the\n"
      "motion is written, HDF5 and XDMF, and the table of the probes, as ritz-run --output; `frames` and `every`\n"
      "as its options. `forces` is 'stored' or 'linear', `precision` 'float64' or 'float32' (nonlinear models).\n"
      "Warnings are RuntimeWarning. Other Python threads run meanwhile, and Ctrl-C ends the run. Raises InputError\n"
      "and NumericalError; then no file is left behind or changed.");
}

}  // namespace ritz::python
