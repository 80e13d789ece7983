#include "inspect.hpp"

#include <algorithm>
#include <map>
#include <ostream>

#include "inspect_text.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/format/names.hpp"

namespace ritz::tools {

namespace {

std::string heading(const char* part) { return "\n  " + padded(part, 12); }
std::ostream& item(std::ostream& out) { return out << "              "; }

/// The constants of a law that is not of E and ν; those that are zero are absent terms.
std::string constants_text(const fem::AnyLaw& law) {
  std::string text;
  if (!fem::constants_of(fem::name(law))) return text;
  for (const auto& [parameter, value] : fem::parameters(law))
    if (value != 0) text += formatted(" %s %.6g,", parameter.name, value);
  return text + " at rest";
}

std::string material_text(const fem::Material& material) {
  const auto elastic = material.at_rest();
  const std::string name = fem::name(material.law);
  return (name == fem::default_law ? "" : " " + name) + constants_text(material.law) +
         formatted(" E %.6g Pa, ν %.6g%s, ρ %.6g kg/m³\n", elastic.young(), elastic.poisson(),
                   elastic.moduli ? " (means over all directions)" : "", material.density);
}

std::string certificate_text(const model::Certificate& c, bool details) {
  if (c.kind == model::Certified::no) return "not certified: modes may be missing";
  const auto name = std::string(format::name(c.kind));
  return formatted("certified: no mode is missing; an independent count%s has %s below %.6g Hz, as many as were found",
                   details ? formatted(" (%s of K − σM, σ = %.6g rad²/s²)", name.c_str(), c.shift).c_str() : "",
                   grouped(c.counted).c_str(), model::frequency(c.shift));
}

}  // namespace

std::string cell_name(std::uint8_t vtk) {
  if (const auto cell = fem::cell_of_vtk(vtk)) return std::string(fem::shape(*cell).name);
  if (const auto face = fem::face_of_vtk(vtk)) return std::string(fem::shape(*face).name);
  return "VTK type " + std::to_string(vtk);
}

void describe_geometry(const model::Geometry& g, std::ostream& out) {
  out << heading("geometry") << grouped(g.points.rows()) << " vertices";
  if (g.rows == model::Rows::surface) out << " of the surface, of " << grouped(g.full_vertices) << " in the mesh";
  out << '\n';
  std::map<std::uint8_t, std::int64_t> counts;
  for (const auto type : g.cells.vtk_types) ++counts[type];
  for (const auto& [type, count] : counts) item(out) << grouped(count) << ' ' << cell_name(type) << " cells\n";
  if (g.points.rows() > 0) {
    const Eigen::RowVector3d low = g.points.colwise().minCoeff(), high = g.points.colwise().maxCoeff();
    item(out) << formatted("box  x %.6g … %.6g   y %.6g … %.6g   z %.6g … %.6g m\n", low[0], high[0], low[1], high[1],
                           low[2], high[2]);
  }
  for (const auto& [region, m] : g.materials)
    item(out) << "material " << padded(printable(region), 16) << material_text(m);
  for (const auto& set : g.sets) {
    item(out) << "set      " << padded(printable(set.name), 16) << ' ' << grouped(set.full_count) << " vertices";
    if (std::ssize(set.rows) < set.full_count) out << ", " << grouped(std::ssize(set.rows)) << " stored";
    out << '\n';
  }
}

void describe_basis(const format::BasisSize& size, std::ostream& out) {
  out << heading("basis") << "U is " << grouped(3 * size.vertices) << " x " << size.columns << ", "
      << byte_size(static_cast<std::uint64_t>(24 * size.vertices * size.columns)) << '\n';
}

void describe_modes(const model::Modes& modes, Voice voice, std::ostream& out) {
  const bool details = voice == Voice::verbose;
  const auto rigid = std::ranges::count(modes.kinds, model::ModeKind::rigid);
  const auto flexible = std::ssize(modes.kinds) - rigid;
  out << heading("modes") << rigid << " rigid, " << flexible << " flexible\n";
  item(out) << certificate_text(modes.certificate, details) << '\n';
  if (details) item(out) << formatted("mass-orthonormal to %.1e\n", modes.orthonormality);
  out << '\n';
  item(out) << "mode  kind       frequency, Hz" << (details ? "   eigenvalue, rad²/s²   residual\n" : "\n");
  for (Eigen::Index i = 0; i < modes.eigenvalues.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double value = modes.eigenvalues[i];
    item(out) << formatted("%4td  %-8s %15.7g", i + 1, format::name(modes.kinds[at]).data(), model::frequency(value));
    if (details)
      out << formatted("   %19.10g   %8.1e%s", value, modes.residuals[i], modes.floor_applies[at] ? " *" : "");
    out << '\n';
  }
  if (details && std::ranges::count(modes.floor_applies, 1) > 0)
    item(out) << "* held to the rounding floor 10 ε‖K‖‖ψ‖, which is above the usual gate\n";
}

void describe_reduction(const model::Reduction& reduction, Voice voice, std::ostream& out) {
  const auto r = reduction.stiffness.size(), kept = reduction.kept();
  const auto& sigma = reduction.singular_values;
  out << heading("reduction") << r << " columns";
  if (reduction.residual_vectors > 0)
    out << ", " << reduction.residual_vectors << " of them residual vectors, the others";
  if (sigma.size() > 0) out << " of " << sigma.size() << " that were found";
  else if (reduction.residual_vectors > 0) out << " modes";
  out << '\n';
  if (voice != Voice::verbose) return;
  if (r > 0)
    item(out) << formatted("λ of UᵀKU %.6g … %.6g rad²/s²\n", reduction.stiffness[0], reduction.stiffness[r - 1]);
  if (kept > 0)
    item(out) << formatted("singular values %.6g … %.6g, of what is left out %.3g\n", sigma[0], sigma[kept - 1],
                           reduction.discarded);
}

void describe_polynomial(const model::Polynomial& p, std::ostream& out) {
  const auto count = p.quadratic.size() + p.cubic.size() + p.quartic.size();
  out << heading("polynomial") << "of " << p.r << " coordinates: " << grouped(p.quadratic.size()) << " quadratic, "
      << grouped(p.cubic.size()) << " cubic, " << grouped(p.quartic.size()) << " quartic coefficients, "
      << byte_size(static_cast<std::uint64_t>(8 * count)) << '\n';
}

void describe_inertia(const model::Inertia& inertia, Voice voice, std::ostream& out) {
  const auto centre = inertia.centre_of_mass();
  out << heading("inertia") << formatted("mass    %.9g kg\n", inertia.mass());
  item(out) << formatted("centre  %.9g  %.9g  %.9g m\n", centre[0], centre[1], centre[2]);
  const auto tensor = inertia.tensor();
  for (int i = 0; i < 3; ++i)
    item(out) << (i == 0 ? "tensor" : "      ")
              << formatted("%15.6g %15.6g %15.6g%s\n", tensor(i, 0), tensor(i, 1), tensor(i, 2),
                           i == 0 ? "  kg m², about the centre" : "");
  const auto effective = inertia.effective_masses();
  if (effective.rows() == 0) return;
  out << '\n';
  item(out) << "effective mass of the columns of U, % of all\n";
  item(out) << "column         x         y         z\n";
  const auto row = [&](const std::string& name, const Eigen::RowVector3d& masses) {
    const Eigen::RowVector3d share = 100 / inertia.mass() * masses;
    item(out) << formatted("%6s %9.4f %9.4f %9.4f\n", name.c_str(), share[0], share[1], share[2]);
  };
  for (Eigen::Index i = 0; i < effective.rows(); ++i) row(std::to_string(i + 1), effective.row(i));
  row("sum", effective.colwise().sum());
  if (voice != Voice::verbose) return;
  out << '\n';
  item(out) << "participation factors UᵀMR: along x y z, √kg; about x y z through the centre, √kg m\n";
  const Eigen::MatrixXd factors = inertia.participation_factors();
  for (Eigen::Index i = 0; i < factors.rows(); ++i) {
    item(out) << formatted("%6td", i + 1);
    for (const double factor : factors.row(i)) out << formatted(" %11.4g", factor);
    out << '\n';
  }
}

void describe_cubature(const model::Cubature& c, std::ostream& out) {
  out << heading("cubature") << "of " << grouped(std::ssize(c.cells)) << " cells with " << grouped(c.volumes.size())
      << " points" << (c.integrand == model::Integrand::energy ? "" : ", of what the polynomial lacks") << '\n';
  item(out) << formatted("tested up to an elastic energy of %.4g J; weights %.3g to %.3g\n", c.largest_energy,
                         c.weights.minCoeff(), c.weights.maxCoeff());
  item(out) << "relative error of forces in the energy norm, in %: root mean square, and largest\n";
  item(out) << "  cells      training            new lifts           new statics\n";
  for (const auto& [cells, training, lifts, statics] : c.errors) {
    item(out) << formatted("%7lld", static_cast<long long>(cells));
    for (const auto* e : {&training, &lifts, &statics})
      out << formatted(" %9.3g %9.3g", 100 * e->root_mean_square, 100 * e->largest);
    out << '\n';
  }
}

void describe_loads(const std::vector<model::SetLoad>& loads, std::ostream& out) {
  if (loads.empty()) return;
  out << heading("loads") << "on " << loads.size() << " sets\n";
  for (const auto& load : loads) {
    item(out) << padded(printable(load.set), 16) << ' ' << grouped(load.vertices) << " vertices";
    if (load.has_surface) out << formatted(", surface of %.6g m²", load.area);
    out << '\n';
  }
}

}  // namespace ritz::tools
