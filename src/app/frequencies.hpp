// The modes as a table, for a file and for printing.
#pragma once
#include <string>

#include "ritz/base/program.hpp"
#include "ritz/model/model.hpp"

namespace ritz::app {

/// A table with the columns "index,kind,frequency_hz,eigenvalue,residual,certified", one row for each mode, with 15
/// digits; then the effective masses along x, y and z, kg, and the participation factors along and about these axes,
/// √kg and √kg m. `inertia` is that over the modes; if it has no columns, because the vectors of the modes are not
/// available, these are left out. Last "mesh_error", unless `mesh_errors` is empty: of each mode f_h / f − 1.
std::string frequencies_csv(const model::Modes& modes, const model::Inertia& inertia,
                            const Eigen::VectorXd& mesh_errors);

/// The first modes, the certificate and the effective masses, as text, and along which axes the modes hold less than
/// 90 % of the mass; to a verbose voice residuals and participation factors too. `inertia` and `mesh_errors` as for
/// frequencies_csv.
std::string modes_lines(const model::Modes& modes, const model::Inertia& inertia, const Eigen::VectorXd& mesh_errors,
                        Voice voice);

}  // namespace ritz::app
