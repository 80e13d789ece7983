// The modes as a table, for a file and for printing.
#pragma once
#include <string>

#include "ritz/model/model.hpp"

namespace ritz::app {

/// A table with the columns "index,kind,frequency_hz,eigenvalue,residual,certified", one row for each mode, with 15
/// digits.
std::string frequencies_csv(const model::Modes& modes);

/// The first modes, the certificate, and the masses that move with them, for people. `inertia`: over the modes, or over
/// no columns where their vectors are not at hand; the masses that move with them are then left out.
std::string modes_lines(const model::Modes& modes, const model::Inertia& inertia);

}  // namespace ritz::app
