// Checks that a model is consistent as a whole, beyond what reading its parts one by one checks.
#pragma once
#include <string_view>

#include "ritz/format/parts.hpp"

namespace ritz::format {

/// max |UᵀMU − I|, computed from the Gram matrix; 0 without columns.
double orthonormality_error(const model::Inertia& inertia);

/// max |K̃(0) − UᵀKU| / max |UᵀKU| (absolute if UᵀKU is zero). The body must have a polynomial, and a reduction or
/// modes.
double stiffness_error(const model::Body& body);

/// Checks, from shapes alone, that the parts present agree on the number of vertices n and of columns r. Throws
/// InputError when they do not, and when there is no such body.
void check_shapes(const ModelReader& in, std::string_view body = schema::default_body);

/// Checks, from shapes alone, that the body has what every body needs: materials, at least one column of U, one mode
/// (or entry of the reduction) for each column, the inertia, and a load for each set that has stored vertices. Throws
/// InputError when one is missing, and as check_shapes does.
void check_complete(const ModelReader& in, std::string_view body = schema::default_body);

/// Checks the witnesses of the parts that were read: as many modes were found below the shift as the inertia counts,
/// UᵀMU = I to 1e-12, and the polynomial's K̃(0) = UᵀKU to 1e-9 of its largest entry. Throws InputError when one fails.
void check_witnesses(const ModelReader& in, const model::Body& body);

/// Does all of these checks and verifies every checksum, for all bodies. Returns the bodies without U, of which only
/// one column at a time is in memory. Throws InputError, also when there is no body.
std::vector<model::Body> check(const ModelReader& in);

}  // namespace ritz::format
