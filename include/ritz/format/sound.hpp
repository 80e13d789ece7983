// What a model must be for its motion to be worth computing, beyond what reading its parts one by one ensures.
#pragma once
#include <string_view>

#include "ritz/format/parts.hpp"

namespace ritz::format {

/// max |UᵀMU − I|, read off the Gram matrix; 0 without columns.
double orthonormality_error(const model::Inertia& inertia);

/// max |K̃(0) − UᵀKU| / max |UᵀKU| of a body that has a polynomial and the numbers of its basis.
double stiffness_error(const model::Body& body);

/// Whether the parts that there are agree on n and r, by their shapes: no numbers are read.
/// Throws InputError where they do not, and where there is no such body.
void check_shapes(const ModelReader& in, std::string_view body = schema::default_body);

/// Throws InputError unless the body has what every body has: materials, at least one column of U, a mode (or an entry
/// of the reduction) for each column, the inertia, and a load for each set of which vertices are stored. Reads shapes
/// alone.
void check_complete(const ModelReader& in, std::string_view body = schema::default_body);

/// The witnesses among the parts that were read: modes counted by the inertia, the polynomial's K̃(0) = UᵀKU.
/// Throws InputError where one fails.
void check_witnesses(const ModelReader& in, const model::Body& body);

/// All of the above and every checksum, of all bodies. Gives their parts but for U, of which one column at a time is in
/// memory. Throws InputError, also where there is no body.
std::vector<model::Body> check(const ModelReader& in);

}  // namespace ritz::format
