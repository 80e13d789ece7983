// How fast a body vibrates, to order of magnitude, before anything is solved.
#pragma once
#include "ritz/stages/assemble.hpp"

namespace ritz::stages {

/// An upper bound on the lowest elastic eigenvalue λ, rad²/s²: Rayleigh-Ritz over displacement fields cubic in the
/// coordinates, less the rigid motions `rigid` (M-orthonormal). *Collective*.
double elastic_scale(const Problem& problem, mesh::FreeRef rigid);

}  // namespace ritz::stages
