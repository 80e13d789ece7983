// The modes as a table, for a file and for printing.
#pragma once
#include <string>

#include "ritz/model/model.hpp"

namespace ritz::app {

/// A table with the columns "index,kind,frequency_hz,eigenvalue,residual,certified", one row for each mode, with 15
/// digits.
std::string frequencies_csv(const model::Modes& modes);

/// The first modes, the certificate and the effective masses, as text. `inertia` is that over the modes; if it has no
/// columns, because the vectors of the modes are not available, the masses are left out.
std::string modes_lines(const model::Modes& modes, const model::Inertia& inertia);

}  // namespace ritz::app
