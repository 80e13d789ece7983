// The modes as a table: a file and what is printed.
#pragma once
#include <string>

#include "ritz/model/model.hpp"

namespace ritz::app {

/// "index,kind,frequency_hz,eigenvalue,residual,certified", a row a mode, 15 digits.
std::string frequencies_csv(const model::Modes& modes);

/// The first modes, the certificate, and the masses that move with them, for people. `inertia`: over the modes, or over
/// no columns where their vectors are not at hand; the masses that move with them are then left out.
std::string modes_lines(const model::Modes& modes, const model::Inertia& inertia);

}  // namespace ritz::app
