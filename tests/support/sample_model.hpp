// A tiny model with every part, known in closed form.
//
// Two point masses of 2 kg at (0,0,0) and (1,0,0), each free to move along z only. The left one hangs on a spring to
// the ground so that λ1 = 4, the right one so that λ2 = 9. Hence U = M^-1/2 along z:
// u = U z has u_z(left) = z1/√2, u_z(right) = z2/√2; K̃ = diag(4, 9). Two more vertices carry no mass and do not move.
#pragma once
#include <vector>

#include "ritz/model/model.hpp"

namespace ritz::test {

model::Geometry sample_geometry();

model::Basis sample_basis();

model::Modes sample_modes();

/// B's rows at the two masses, M_s = 2 I: columns 1, X, Y, Z, U_x (2), U_y (2), U_z (2).
model::Inertia sample_inertia();

std::vector<model::SetLoad> sample_loads();

model::Provenance sample_provenance();

model::Report sample_report();

model::Model sample_model();

}  // namespace ritz::test
