// What the programs do with a model.
#pragma once
#include "ritz/format/reader.hpp"

namespace ritz::fuzz {

/// Reads a model as ritz-inspect does, with and without --check, and as ritz-run does. Throws the first InputError that
/// one of the two has, after all had their turn; a finding where --check takes what ritz-run refuses.
void read_as_all_programs(const format::ModelReader& in);

}  // namespace ritz::fuzz
