// What ritz-inspect says about a model.
#pragma once
#include <iosfwd>

#include "ritz/format/reader.hpp"

namespace ritz::tools {

/// Prints all there is: provenance, the parts of each body, the report, the datasets. Frequencies in Hz, the rest in
/// SI. Throws InputError for a damaged file.
void describe(const format::ModelReader& in, std::ostream& out);

}  // namespace ritz::tools
