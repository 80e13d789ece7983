#include "parts.hpp"

#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "exchange.hpp"
#include "ritz/format/names.hpp"
#include "ritz/model/model.hpp"

namespace ritz::python {
namespace {

std::string certified(const model::Modes& modes) {
  switch (modes.certificate.kind) {
    case model::Certified::no: return "no";
    case model::Certified::probabilistic: return "probabilistic";
    case model::Certified::inertia_f32: return "inertia-f32";
    case model::Certified::inertia: return "inertia";
  }
  return {};
}

Eigen::VectorXd frequencies(const model::Modes& modes) { return modes.eigenvalues.unaryExpr(&model::frequency); }

/// A read-only view of an array that is a member of a part.
template <class Value, class Member>
auto member(Member Value::*which) {
  return [which](const py::object& self) { return view(self, self.cast<const Value&>().*which); };
}

Eigen::MatrixXd error_rows(const std::vector<model::CubatureError>& errors) {
  Eigen::MatrixXd rows(std::ssize(errors), 7);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const auto& [cells, training, lifts, statics] = errors[static_cast<std::size_t>(i)];
    rows.row(i) << static_cast<double>(cells), training.root_mean_square, training.largest, lifts.root_mean_square,
        lifts.largest, statics.root_mean_square, statics.largest;
  }
  return rows;
}

}  // namespace

void define_parts(py::module_& module) {
  using model::Cubature, model::Inertia, model::Modes, model::Polynomial, model::Reduction, model::Report;
  py::class_<Modes, std::shared_ptr<Modes>>(module, "Modes", "The k modes of K psi = lambda M psi, rigid ones first.")
      .def_property_readonly("eigenvalues", member(&Modes::eigenvalues),
                             "lambda, (k,), rad2/s2, ascending; 0 for a rigid mode")
      .def_property_readonly(
          "frequencies", [](const Modes& modes) { return copied(frequencies(modes)); }, "(k,), Hz; a new array")
      .def_property_readonly("energies", member(&Modes::energies),
                             "psi.K.psi / psi.M.psi as computed, (k,), rad2/s2; of rigid modes it tells how rigid they "
                             "are")
      .def_property_readonly("residuals", member(&Modes::residuals),
                             "|K psi - lambda M psi| / (lambda |M psi|), (k,); of a rigid mode |K psi| / (|K| |psi|)")
      .def_property_readonly(
          "flexible", [](const py::object& self) { return view_flags(self, self.cast<const Modes&>().kinds); },
          "whether the mode is flexible, (k,), bool")
      .def_property_readonly(
          "floor_applies",
          [](const py::object& self) { return view_flags(self, self.cast<const Modes&>().floor_applies); },
          "whether the residual passed only because rounding explains it, (k,), bool")
      .def_readonly("orthonormality", &Modes::orthonormality, "max |psi_i.M.psi_j - delta_ij|")
      .def_property_readonly("certified", &certified,
                             "how the number of modes is certified: 'inertia', 'inertia-f32', 'probabilistic' or 'no'")
      .def_property_readonly(
          "shift", [](const Modes& modes) { return modes.certificate.shift; },
          "sigma, rad2/s2, above the last mode, below which modes were counted")
      .def_property_readonly(
          "counted", [](const Modes& modes) { return modes.certificate.counted; }, "eigenvalues below it, counted")
      .def_property_readonly(
          "found", [](const Modes& modes) { return modes.certificate.found; }, "eigenvalues below it, computed");

  py::class_<Reduction, std::shared_ptr<Reduction>>(module, "Reduction",
                                                    "How a basis of modal derivatives or snapshots was made.")
      .def_property_readonly("stiffness", member(&Reduction::stiffness),
                             "the diagonal of U.K.U, (r,), rad2/s2, ascending; its other entries are 0")
      .def_property_readonly("singular_values", member(&Reduction::singular_values),
                             "sigma of the vectors that U was made from, descending; U keeps the first r")
      .def_readonly("discarded", &Reduction::discarded,
                    "sqrt of the sum of sigma2 over all that U leaves out, with a bound for what was not computed");

  py::class_<Polynomial, std::shared_ptr<Polynomial>>(
      module, "Polynomial",
      "The energy of St. Venant-Kirchhoff material over U, J:\n"
      "  E(z) = A_ij z_i z_j / 2 + B_ijk z_i z_j z_k / 6 + C_ijkl z_i z_j z_k z_l / 24\n"
      "with symmetric A, B, C, of which the entries i <= j <= k <= l are stored in lexicographic order.")
      .def_readonly("r", &Polynomial::r, "the number of reduced coordinates")
      .def_property_readonly("quadratic", member(&Polynomial::quadratic), "A, (r(r+1)/2,), 1/s2")
      .def_property_readonly("cubic", member(&Polynomial::cubic), "B, (r(r+1)(r+2)/6,), 1/(s2 m sqrt(kg))")
      .def_property_readonly("quartic", member(&Polynomial::quartic), "C, (r(r+1)(r+2)(r+3)/24,), 1/(s2 m2 kg)");

  py::class_<Cubature, std::shared_ptr<Cubature>>(
      module, "Cubature",
      "The energy of any law over U, summed over T cells with P points together; beside a polynomial what that one "
      "lacks.")
      .def_property_readonly(
          "integrand", [](const Cubature& cubature) { return std::string(format::name(cubature.integrand)); },
          "'energy', or 'beyond-polynomial' where the body has a polynomial, too")
      .def_property_readonly(
          "cells", [](const py::object& self) { return view(self, self.cast<const Cubature&>().cells); },
          "the mesh file's numbers of the cells, (T,), ascending")
      .def_property_readonly("weights", member(&Cubature::weights), "of the cells, (T,), > 0")
      .def_property_readonly(
          "starts", [](const py::object& self) { return view(self, self.cast<const Cubature&>().starts); },
          "cell c has the points starts[c] ... starts[c + 1], (T + 1,)")
      .def_property_readonly("volumes", member(&Cubature::volumes), "of the points, (P,), m3")
      .def_property_readonly("gradients", member(&Cubature::gradients),
                             "row 9p + 3j + i: du_i/dX_j of the columns of U at point p, (9P, r), 1/(m sqrt(kg))")
      .def_readonly("largest_energy", &Cubature::largest_energy,
                    "of the poses of the training, J: beyond it the error is not known")
      .def_property_readonly(
          "errors", [](const Cubature& cubature) { return copied(error_rows(cubature.errors)); },
          "relative errors of forces in the energy norm, a row for each number of cells tried, the last for this "
          "cubature: cells, then root mean square and largest of training, held-out lifts and held-out statics, "
          "(q, 7); a new array");

  py::class_<Inertia, std::shared_ptr<Inertia>>(module, "Inertia", "The inertia of the whole body.")
      .def_property_readonly("gram", member(&Inertia::gram),
                             "G = B.M.B with the scalar mass M and B = [1, X, Y, Z, U_x, U_y, U_z], (4 + 3r, 4 + 3r)")
      .def_property_readonly("origin", member(&Inertia::origin), "from which X, Y, Z count, (3,), m")
      .def_property_readonly("mass", &Inertia::mass, "of the body, kg")
      .def_property_readonly(
          "centre_of_mass", [](const Inertia& inertia) { return copied(inertia.centre_of_mass()); },
          "(3,), m; a new array")
      .def_property_readonly(
          "tensor", [](const Inertia& inertia) { return copied(inertia.tensor()); },
          "about the centre of mass, (3, 3), kg m2; a new array")
      .def_property_readonly(
          "rigid_coupling", [](const Inertia& inertia) { return copied(inertia.rigid_coupling()); },
          "U.M.R, (r, 6), sqrt(kg) and sqrt(kg) m: R are unit translations and rotations about the centre of mass; a "
          "new array");

  py::class_<Report, std::shared_ptr<Report>>(module, "Report",
                                              "Diagnostics of the reduction; no motion depends on them.")
      .def_property_readonly(
          "figures",
          [](const Report& report) {
            py::dict all;
            for (const auto& [name, value] : report.figures) all[py::str(name)] = value;
            return all;
          },
          "iterations, errors, peak memory and counts, by name")
      .def_property_readonly(
          "seconds",
          [](const Report& report) {
            std::vector<std::pair<std::string, double>> all;
            for (const auto& [stage, seconds] : report.seconds) all.emplace_back(stage, seconds);
            return all;
          },
          "(stage, s) of each stage, in their order")
      .def_readonly("notes", &Report::notes, "the warnings that were printed");
}

}  // namespace ritz::python
