// The order of magnitude of a body's lowest frequency, before anything is solved.
#pragma once
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// *Collective*. An upper bound on the lowest elastic eigenvalue λ, rad²/s²: Rayleigh-Ritz over displacement fields
/// that are cubic in the coordinates, orthogonal to the rigid motions `rigid` (M-orthonormal).
double elastic_scale(const Problem& problem, mesh::FreeRef rigid);

}  // namespace ritz::stages
