// What the programs do with a model.
#pragma once
#include "ritz/format/reader.hpp"

namespace ritz::fuzz {

/// Reads a model as ritz-inspect does, with and without --check, and as ritz-run does. Throws the first InputError that
/// one of them has, after all had their turn; a finding where ritz-run takes what --check refuses, or the other way.
void read_as_all_programs(const format::ModelReader& in);

}  // namespace ritz::fuzz
