// The cells that a cubature may choose from.
#pragma once
#include <vector>

#include "ritz/model/model.hpp"
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// The most cells that a cubature chooses from.
inline constexpr std::int64_t most_candidates = 20'000;

/// *Collective*. Local numbers of owned cells, those of one region side by side: of Integrand::energy all cells, of
/// Integrand::beyond_polynomial those whose law's force is no polynomial. Of more than `most` a sample of `most`, which
/// is the same on any number of ranks: cells are classed by the octave of their volume, and a class has a share that is
/// the mean of its shares of the cells and of the volume. In a class the cells have equal chances, which a hash of
/// their positions in the file decides.
std::vector<int> cubature_candidates(const Problem& problem, model::Integrand integrand,
                                     std::int64_t most = most_candidates);

}  // namespace ritz::stages
