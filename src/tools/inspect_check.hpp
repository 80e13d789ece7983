// ritz-inspect --check.
#pragma once
#include <iosfwd>

#include "ritz/format/reader.hpp"

namespace ritz::tools {

/// Verifies every checksum and what must hold between the parts: none missing, shapes, finite numbers, eigenvalues that
/// ascend with the rigid ones first, no mode missed below the certificate's shift, UᵀMU = I to 1e-12, the polynomial's
/// K̃(0) equal to the reduction's diagonal to 1e-9 of its largest entry. Prints an "ok" line a check. Throws InputError
/// with one sentence on the first that fails.
void check(const format::ModelReader& in, std::ostream& out);

}  // namespace ritz::tools
