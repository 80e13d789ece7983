#include "ritz/format/summaries.hpp"

#include <algorithm>
#include <utility>

#include "ritz/format/names.hpp"

namespace ritz::format {
namespace {

using files::Json, files::json_list;

Json matrix_rows(const Eigen::MatrixXd& matrix) {
  Json::Array rows;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.emplace_back(json_list(matrix.row(i)));
  return rows;
}

Json::Object certificate_members(const model::Certificate& certificate) {
  return {{"kind", name(certificate.kind)},
          {"shift", certificate.shift},
          {"shift_hz", model::frequency(certificate.shift)},
          {"counted", certificate.counted},
          {"found", certificate.found}};
}

}  // namespace

Json::Array summary(const std::vector<model::StageTime>& stages) {
  Json::Array list;
  for (const auto& [stage, seconds] : stages) list.emplace_back(Json::Object{{"stage", stage}, {"seconds", seconds}});
  return list;
}

Json::Object summary(const model::Modes& modes, const model::Inertia* over_modes) {
  const auto rigid = std::ranges::count(modes.kinds, model::ModeKind::rigid);
  Json::Array kinds, frequencies;
  for (const auto kind : modes.kinds) kinds.emplace_back(name(kind));
  for (const double eigenvalue : modes.eigenvalues) frequencies.emplace_back(model::frequency(eigenvalue));
  return {{"rigid", rigid},
          {"flexible", modes.eigenvalues.size() - rigid},
          {"orthonormality", modes.orthonormality},
          {"certificate", certificate_members(modes.certificate)},
          {"kind", std::move(kinds)},
          {"frequency_hz", std::move(frequencies)},
          {"eigenvalue", json_list(modes.eigenvalues)},
          {"residual", json_list(modes.residuals)},
          {"effective_mass", over_modes ? matrix_rows(over_modes->effective_masses()) : nullptr},
          {"participation", over_modes ? matrix_rows(over_modes->participation_factors()) : nullptr}};
}

Json::Object summary(const model::Reduction& reduction) {
  const auto& sigma = reduction.singular_values;
  const Eigen::Index kept = reduction.kept();
  return {{"columns", reduction.stiffness.size()},
          {"residual_vectors", reduction.residual_vectors},
          {"singular_values_kept", json_list(sigma.head(kept))},
          {"singular_values_left_out", json_list(sigma.tail(sigma.size() - kept))},
          {"discarded", reduction.discarded}};
}

Json::Object summary(const model::Polynomial& polynomial) {
  return {{"coordinates", polynomial.r},
          {"quadratic", polynomial.quadratic.size()},
          {"cubic", polynomial.cubic.size()},
          {"quartic", polynomial.quartic.size()}};
}

Json::Object summary(const model::Cubature& cubature) {
  Json::Array errors;
  const auto pair = [](const model::PoseErrors& e) {
    return Json::Object{{"root_mean_square", e.root_mean_square}, {"largest", e.largest}};
  };
  for (const auto& error : cubature.errors)
    errors.emplace_back(Json::Object{{"cells", error.cells},
                                     {"training", pair(error.training)},
                                     {"lifts", pair(error.lifts)},
                                     {"statics", pair(error.statics)}});
  return {{"integrand", name(cubature.integrand)},
          {"cells", std::ssize(cubature.cells)},
          {"points", cubature.volumes.size()},
          {"largest_energy", cubature.largest_energy},
          {"errors", std::move(errors)}};
}

Json::Object summary(const model::Inertia& inertia) {
  return {{"centre_of_mass", json_list(inertia.centre_of_mass())}, {"tensor", matrix_rows(inertia.tensor())}};
}

}  // namespace ritz::format
