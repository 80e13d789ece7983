// ritz-inspect --check.
#pragma once
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "ritz/format/reader.hpp"

namespace ritz::tools {

/// What was measured of a body.
struct CheckedBody {
  std::string name;
  double orthonormality = 0;        ///< max |UᵀMU − I|
  std::optional<double> stiffness;  ///< max |K̃(0) − UᵀKU| / max |UᵀKU| of a polynomial
};

/// Verifies every checksum and what must hold between the parts: none missing, shapes, finite numbers, eigenvalues that
/// ascend with the rigid ones first, no mode missed below the certificate's shift, UᵀMU = I to 1e-12, the polynomial's
/// K̃(0) equal to the reduction's diagonal to 1e-9 of its largest entry. Prints an "ok" line a check. Throws InputError
/// with one sentence on the first that fails.
std::vector<CheckedBody> check(const format::ModelReader& in, std::ostream& out);

}  // namespace ritz::tools
