#include "body.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>
#include <string>
#include <vector>

#include "exchange.hpp"
#include "ritz/format/library.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/format/sound.hpp"
#include "ritz/scene/scene.hpp"
#include "ritz/world/body.hpp"
#include "ritz/world/loads.hpp"

namespace ritz::python {
namespace {

LoadedBody read(const std::filesystem::path& file, const std::string& name, const std::string& forces) {
  const bool linear = one_of({"stored", "linear"}, forces, "forces") == 1;
  format::silence_errors();
  const format::ModelReader in(file);
  if (!name.empty()) in.require_body(name);
  const auto which = name.empty() ? in.first_body() : name;
  format::check_complete(in, which);
  auto body = std::make_shared<model::Body>(format::read_body(in, which));
  format::check_witnesses(in, *body);
  if (linear) {
    body->polynomial.reset();
    body->cubature.reset();
  }
  return {std::move(body), file};
}

std::vector<std::string> bodies(const std::filesystem::path& file) {
  format::silence_errors();
  return format::ModelReader(file).bodies();
}

/// A part of a body, which keeps the body alive; None where the body has none.
template <class Value>
std::shared_ptr<Value> part(const LoadedBody& body, const std::optional<Value>& value) {
  if (!value) return nullptr;
  return std::shared_ptr<Value>(std::const_pointer_cast<model::Body>(body.value), const_cast<Value*>(&*value));
}

const model::Geometry& geometry(const py::object& self) { return self.cast<const LoadedBody&>().value->geometry; }

py::dict sets(const py::object& self) {
  py::dict all;
  for (const auto& set : geometry(self).sets) all[py::str(set.name)] = view(self, set.rows);
  return all;
}

/// What a load does, r numbers.
Eigen::VectorXd reduced(const LoadedBody& body, const scene::Load& load) {
  const scene::Scene scene{
      .analysis = scene::Static{1}, .damping = {}, .gravity = {}, .shake = {}, .loads = {load}, .probes = {}};
  return world::reduce_loads(scene, *body.value).terms.front().force;
}

py::array_t<double> pressure(const LoadedBody& body, const std::string& set) {
  return copied(reduced(body, {.target = set, .kind = scene::Pressure{1}, .table = {}}));
}

py::array_t<double> traction(const LoadedBody& body, const std::string& set) {
  Eigen::MatrixXd columns(world::reduced_size(*body.value), 3);
  for (Eigen::Index i = 0; i < 3; ++i) {
    scene::Vector3 axis{};
    axis[static_cast<std::size_t>(i)] = 1;
    columns.col(i) = reduced(body, {.target = set, .kind = scene::Traction{axis}, .table = {}});
  }
  return copied(columns);
}

py::array_t<double> gravity(const LoadedBody& body, py::handle given) {
  const auto g = numbers(given, "gravity", {3}, "an acceleration along x, y and z");
  return copied((body.value->inertia->rigid_coupling().leftCols<3>() * vector(g)).eval());
}

}  // namespace

void define_body(py::module_& module) {
  py::class_<LoadedBody>(
      module, "Body",
      "A reduced body of a model file: n stored vertices, r columns of U.\n\n"
      "All arrays are read-only views of what was read, and stay valid when the body itself is deleted.")
      .def_property_readonly(
          "name", [](const LoadedBody& body) { return body.value->name; }, "as the file has it")
      .def_property_readonly(
          "file", [](const LoadedBody& body) { return body.file; }, "the model file, a Path")
      .def_property_readonly(
          "r", [](const LoadedBody& body) { return world::reduced_size(*body.value); },
          "the number of reduced coordinates z, sqrt(kg) m")
      .def_property_readonly(
          "U", [](const py::object& self) { return view(self, self.cast<const LoadedBody&>().value->basis.U); },
          "the basis of displacements u = U z, (3n, r), 1/sqrt(kg): rows x, y, z of each vertex")
      .def_property_readonly(
          "points", [](const py::object& self) { return view(self, geometry(self).points); },
          "the vertices at rest, (n, 3), m")
      .def_property_readonly(
          "vertex_ids", [](const py::object& self) { return view(self, geometry(self).vertex_ids); },
          "the mesh file's own number of each vertex, (n,)")
      .def_property_readonly(
          "full_vertices", [](const LoadedBody& body) { return body.value->geometry.full_vertices; },
          "number of vertices of the whole mesh, more than n where the surface alone is stored")
      .def_property_readonly(
          "cell_types", [](const py::object& self) { return view(self, geometry(self).cells.vtk_types); },
          "VTK's number of each cell to draw, (cells,)")
      .def_property_readonly(
          "cell_offsets", [](const py::object& self) { return view(self, geometry(self).cells.offsets); },
          "cell i has cell_vertices[cell_offsets[i]:cell_offsets[i + 1]], (cells + 1,)")
      .def_property_readonly(
          "cell_vertices", [](const py::object& self) { return view(self, geometry(self).cells.vertices); },
          "rows of `points`, in VTK's order")
      .def_property_readonly("sets", &sets, "by name, the rows of `points` that belong to each set and are stored")
      .def_property_readonly(
          "modes", [](const LoadedBody& body) { return part(body, body.value->modes); }, "the modes, or None")
      .def_property_readonly(
          "reduction", [](const LoadedBody& body) { return part(body, body.value->reduction); },
          "how the basis was made; None where the columns of U are the modes")
      .def_property_readonly(
          "polynomial", [](const LoadedBody& body) { return part(body, body.value->polynomial); },
          "the energy of large displacements; None for small ones")
      .def_property_readonly(
          "cubature", [](const LoadedBody& body) { return part(body, body.value->cubature); },
          "the energy of laws that are no polynomials; None where there is none")
      .def_property_readonly(
          "inertia", [](const LoadedBody& body) { return part(body, body.value->inertia); },
          "the inertia of the whole body")
      .def_property_readonly(
          "report",
          [](const LoadedBody& body) {
            return std::shared_ptr<model::Report>(std::const_pointer_cast<model::Body>(body.value),
                                                  const_cast<model::Report*>(&body.value->report));
          },
          "diagnostics of the reduction")
      .def_property_readonly(
          "checksums",
          [](const LoadedBody& body) {
            py::dict all;
            all["mesh"] = body.value->checksums.mesh;
            all["problem"] = body.value->checksums.problem;
            return all;
          },
          "of the 'mesh', and of the 'problem': mesh, materials and supports")
      .def(
          "unit_force",
          [](const LoadedBody& body, const scene::Target& target) {
            return copied(world::unit_force(*body.value, target));
          },
          py::arg("target"),
          "What a force of 1 N along x, y, z does, (r, 3), 1/sqrt(kg): F = body.unit_force('tip'), then F @ f is the\n"
          "load of the force f, and F.T @ z the displacement, m. `target` is a vertex, by the mesh file's number, or "
          "a\n"
          "set, whose vertices share the force equally, and of which F.T @ z is the mean displacement.")
      .def("pressure", &pressure, py::arg("set"),
           "The load of a pressure of 1 Pa, which pushes into the body, (r,), m2/sqrt(kg)")
      .def("traction", &traction, py::arg("set"), "The loads of tractions of 1 Pa along x, y, z, (r, 3), m2/sqrt(kg)")
      .def("gravity", &gravity, py::arg("acceleration"),
           "The load of the body's weight under this acceleration, (3,), m/s2: (r,), N/sqrt(kg)");

  module.def(
      "read", &read, py::arg("file"), py::arg("body") = "", py::arg("forces") = "stored",
      "Reads a body of a model file, by default the first one, and checks it as ritz-run does: shapes, checksums,\n"
      "orthonormality, the number of modes. With forces='linear' its polynomial is left out, and displacements\n"
      "are small. Raises InputError.");
  module.def("bodies", &bodies, py::arg("file"), "The names of the bodies of a model file, in their order.");
}

}  // namespace ritz::python
