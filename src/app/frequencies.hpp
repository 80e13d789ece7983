// The modes as a table, for a file and for printing.
#pragma once
#include <string>

#include "ritz/model/model.hpp"

namespace ritz::app {

/// A table with the columns "index,kind,frequency_hz,eigenvalue,residual,certified", one row for each mode, with 15
/// digits; then the effective masses along x, y and z, kg, and the participation factors along and about these axes,
/// √kg and √kg m. `inertia` is that over the modes; if it has no columns, because the vectors of the modes are not
/// available, these are left out.
std::string frequencies_csv(const model::Modes& modes, const model::Inertia& inertia);

/// The first modes, the certificate and the effective masses, as text, and along which axes the modes hold less than
/// 90 % of the mass. `inertia` as for frequencies_csv.
std::string modes_lines(const model::Modes& modes, const model::Inertia& inertia);

}  // namespace ritz::app
