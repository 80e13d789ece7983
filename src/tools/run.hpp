// What ritz-run does.
#pragma once
#include <iosfwd>

#include "run_options.hpp"

namespace ritz::tools {

/// Reads scene and model, runs, writes the motion, and says in one line on `out` what was done (unless quiet); warnings
/// go to `err`. Throws InputError and NumericalError; then no file is left behind or changed.
void run(const RunOptions& options, std::ostream& out, std::ostream& err);

}  // namespace ritz::tools
