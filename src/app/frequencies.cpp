#include "ritz/app/frequencies.hpp"

#include <algorithm>

#include "ritz/base/shown.hpp"
#include "ritz/format/names.hpp"

namespace ritz::app {
namespace {

constexpr Eigen::Index most_rows = 30;  ///< of the printed table
constexpr double enough_mass = .9;      ///< of the body's, as codes for earthquakes ask

std::string participation(const model::Inertia& inertia, Eigen::Index modes) {
  const Eigen::MatrixXd factors = inertia.participation_factors();
  std::string text =
      "  mode  participation factors U^T M R: along x y z, kg^1/2; about x y z through the centre of mass, kg^1/2 m\n";
  for (Eigen::Index i = 0; i < modes; ++i) {
    text += formatted("%6td", i + 1);
    for (const double factor : factors.row(i)) text += formatted("  %11.4g", factor);
    text += '\n';
  }
  return text;
}

/// A sentence on the axes along which the modes hold little of the mass; empty if there are none.
std::string missing_mass(const Eigen::RowVector3d& shares) {
  std::string axes;
  for (Eigen::Index d = 0; d < 3; ++d)
    if (shares[d] < enough_mass)
      axes += (axes.empty() ? "" : ", ") + formatted("%.1f %% along %c", 100 * shares[d], "xyz"[d]);
  if (axes.empty()) return "";
  return "these modes hold only " + axes +
         " of the body's mass, that of held vertices included: gravity, shaking and static loads along these axes are "
         "not answered in full; take more modes, or add -residual_vectors, which makes static answers exact\n";
}

/// "rigid" or "flexible".
const char* kind_of(const model::Modes& modes, Eigen::Index i) {
  return format::name(modes.kinds[static_cast<std::size_t>(i)]).data();
}

}  // namespace

std::string frequencies_csv(const model::Modes& modes, const model::Inertia& inertia,
                            const Eigen::VectorXd& mesh_errors) {
  const std::string certified(format::name(modes.certificate.kind));
  const Eigen::MatrixXd masses = inertia.effective_masses(), factors = inertia.participation_factors();
  const bool moving = masses.rows() == modes.eigenvalues.size();
  std::string text = "index,kind,frequency_hz,eigenvalue,residual,certified";
  if (moving)
    text +=
        ",effective_mass_x,effective_mass_y,effective_mass_z,participation_x,participation_y,participation_z,"
        "participation_about_x,participation_about_y,participation_about_z";
  if (mesh_errors.size() > 0) text += ",mesh_error";
  text += '\n';
  for (Eigen::Index i = 0; i < modes.eigenvalues.size(); ++i) {
    text += formatted("%td,%s,%.15g,%.15g,%.15g,%s", i + 1, kind_of(modes, i), model::frequency(modes.eigenvalues[i]),
                      modes.eigenvalues[i], modes.residuals[i], certified.c_str());
    if (moving) {
      for (const double mass : masses.row(i)) text += formatted(",%.10g", mass);
      for (const double factor : factors.row(i)) text += formatted(",%.10g", factor);
    }
    if (mesh_errors.size() > 0) text += formatted(",%.4g", mesh_errors[i]);
    text += '\n';
  }
  return text;
}

std::string modes_lines(const model::Modes& modes, const model::Inertia& inertia, const Eigen::VectorXd& mesh_errors,
                        Voice voice) {
  const bool details = voice == Voice::verbose;
  const Eigen::Vector3d centre = inertia.centre_of_mass();
  const Eigen::Matrix3d tensor = inertia.tensor();
  const Eigen::MatrixXd masses = inertia.effective_masses();
  const double mass = inertia.mass();
  std::string text =
      formatted("mass %.6g kg, centre of mass (%.6g, %.6g, %.6g) m\n", mass, centre.x(), centre.y(), centre.z());
  text += formatted("moments of inertia about it (xx yy zz xy yz zx): %.5g %.5g %.5g %.5g %.5g %.5g kg m2\n",
                    tensor(0, 0), tensor(1, 1), tensor(2, 2), tensor(0, 1), tensor(1, 2), tensor(2, 0));
  const bool moving = masses.rows() == modes.eigenvalues.size();
  text += "  mode  kind       frequency Hz";
  if (mesh_errors.size() > 0) text += "          estimated error";
  if (details) text += "    residual";
  text += moving ? "   effective mass x      y      z\n" : "\n";
  const auto shown = std::min(most_rows, modes.eigenvalues.size());
  for (Eigen::Index i = 0; i < shown; ++i) {
    text += formatted("%6td  %-8s %14.7g", i + 1, kind_of(modes, i), model::frequency(modes.eigenvalues[i]));
    if (mesh_errors.size() > 0) text += formatted("   mesh: about %+8.2g %%", 100 * mesh_errors[i]);
    if (details) text += formatted("  %10.2e", modes.residuals[i]);
    text += moving ? formatted("          %6.2f %% %6.2f %6.2f\n", 100 * masses(i, 0) / mass, 100 * masses(i, 1) / mass,
                               100 * masses(i, 2) / mass)
                   : "\n";
  }
  if (shown < modes.eigenvalues.size())
    text += formatted("  ... %td more in the table of frequencies\n", modes.eigenvalues.size() - shown);
  if (moving)
    text += "   all modes" + std::string(29 + (mesh_errors.size() > 0 ? 25 : 0) + (details ? 12 : 0), ' ') +
            formatted("%6.2f %% %6.2f %6.2f\n", 100 * masses.col(0).sum() / mass, 100 * masses.col(1).sum() / mass,
                      100 * masses.col(2).sum() / mass) +
            missing_mass(masses.colwise().sum() / mass);
  if (moving && details) text += participation(inertia, shown);
  const auto& c = modes.certificate;
  if (c.kind == model::Certified::inertia)
    text +=
        formatted("certified: no mode is missing; an independent count%s has %lld below %.6g Hz, as many as were found",
                  details ? " (Sturm sequence of K - sigma M)" : "", static_cast<long long>(c.counted),
                  model::frequency(c.shift)) +
        (c.found > modes.eigenvalues.size() ? formatted("; the first %td are kept\n", modes.eigenvalues.size()) : "\n");
  else if (std::ranges::count(modes.kinds, model::ModeKind::flexible) > 0)
    text += "not certified: modes may be missing, as only -solver direct can count them\n";
  return text;
}

}  // namespace ritz::app
