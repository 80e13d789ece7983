#include "ritz/app/report.hpp"

#include <algorithm>

#include "ritz/app/resources.hpp"

namespace ritz::app {
namespace {

using Figures = decltype(model::Report::figures);

namespace names {
constexpr const char* eigensolver_iterations = "eigensolver_iterations";
constexpr const char* pairs = "derivative_pairs";
constexpr const char* solved = "derivatives_solved";
constexpr const char* skipped = "derivatives_skipped";
constexpr const char* iterations = "derivative_iterations";
constexpr const char* residual = "derivative_residual";
constexpr const char* orthonormality = "basis_orthonormality";
constexpr const char* target = "accuracy_target";
constexpr const char* error = "accuracy_error";
constexpr const char* modes = "accuracy_modes";
constexpr const char* columns = "accuracy_columns";
constexpr const char* taylor_slope = "witness_taylor_slope";
constexpr std::string_view static_error =
    "static_error_";  ///< then an axis and, behind a blank, a set if it is not gravity
}  // namespace names

void add_basis(const BasisFigures& basis, Figures& figures) {
  if (const auto& d = basis.derivatives)
    figures.insert(figures.end(), {{names::pairs, d->pairs},
                                   {names::solved, d->solved},
                                   {names::skipped, d->pairs - d->solved},
                                   {names::iterations, d->iterations},
                                   {names::residual, d->residual}});
  if (basis.orthonormality) figures.emplace_back(names::orthonormality, *basis.orthonormality);
  if (const auto& a = basis.accuracy)
    figures.insert(figures.end(), {{names::target, a->target},
                                   {names::error, a->reached.error},
                                   {names::modes, a->reached.modes},
                                   {names::columns, a->reached.columns}});
  if (basis.taylor_slope) figures.emplace_back(names::taylor_slope, *basis.taylor_slope);
  for (const auto& [place, axis, missing] : basis.static_errors)
    figures.emplace_back(std::string(names::static_error) + "xyz"[axis] + (place ? " " + *place : ""), missing);
}

std::vector<stages::StaticError> static_errors(const Figures& figures) {
  std::vector<stages::StaticError> errors;
  for (const auto& [name, value] : figures) {
    if (!name.starts_with(names::static_error) || name.size() <= names::static_error.size()) continue;
    const auto axis = std::string_view("xyz").find(name[names::static_error.size()]);
    if (axis == std::string_view::npos) continue;
    const auto rest = name.substr(names::static_error.size() + 1);
    const auto place = rest.empty() ? stages::LoadPlace() : stages::LoadPlace(rest.substr(1));
    errors.push_back({place, static_cast<int>(axis), value});
  }
  return errors;
}

std::optional<double> find(const model::Report& report, const char* name) {
  const auto found = std::ranges::find(report.figures, name, &Figures::value_type::first);
  return found == report.figures.end() ? std::nullopt : std::optional(found->second);
}

int count(const model::Report& report, const char* name) { return static_cast<int>(find(report, name).value_or(0)); }

}  // namespace

model::Report report(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Results& results, const Progress& progress) {
  model::Report report;
  report.seconds = progress.seconds();
  report.notes = progress.warnings();
  report.mesh_errors = results.mesh_errors;
  report.figures = {{"vertices", static_cast<double>(mesh.vertices_total)},
                    {"cells", static_cast<double>(mesh.cells_total)},
                    {"degrees_of_freedom", static_cast<double>(dofs.total)},
                    {"pieces", static_cast<double>(mesh.pieces)},
                    {"dropped_vertices", static_cast<double>(mesh.dropped_vertices)},
                    {names::eigensolver_iterations, static_cast<double>(results.modes.iterations)},
                    {"peak_memory_bytes", peak_memory(mesh.comm).all_ranks}};
  add_basis(results.basis.figures, report.figures);
  if (const auto& polynomial = results.forces.polynomial)
    report.figures.insert(report.figures.end(), {{"witness_force", polynomial->errors.force},
                                                 {"witness_energy", polynomial->errors.energy},
                                                 {"witness_stiffness", polynomial->errors.stiffness}});
  return report;
}

BasisFigures basis_figures(const model::Report& report) {
  BasisFigures basis;
  basis.orthonormality = find(report, names::orthonormality);
  basis.taylor_slope = find(report, names::taylor_slope);
  if (find(report, names::pairs))
    basis.derivatives = {.pairs = count(report, names::pairs),
                         .solved = count(report, names::solved),
                         .iterations = count(report, names::iterations),
                         .residual = find(report, names::residual).value_or(0)};
  if (const auto target = find(report, names::target))
    basis.accuracy = {*target,
                      {.modes = count(report, names::modes),
                       .columns = count(report, names::columns),
                       .error = find(report, names::error).value_or(0)}};
  basis.static_errors = static_errors(report.figures);
  return basis;
}

int eigensolver_iterations(const model::Report& report) { return count(report, names::eigensolver_iterations); }

}  // namespace ritz::app
