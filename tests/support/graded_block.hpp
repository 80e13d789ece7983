// The common block, 1 x 0.10 x 0.06 m, with cells where the strains are.
#pragma once
#include "support/problem.hpp"

namespace ritz::test {

/// nx x ny x nz x 6 quadratic tetrahedra with straight edges that grow smaller towards the clamp at x = 0 and the
/// sides. *Collective*.
mesh::Mesh graded_block(int nx, int ny, int nz);

}  // namespace ritz::test
