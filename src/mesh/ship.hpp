// Parts of a mesh as messages.
#pragma once
#include "ritz/mesh/part.hpp"

namespace ritz::mesh {

void send_part(MPI_Comm comm, const Part& part, int to);
Part receive_part(MPI_Comm comm, int from = 0);

/// Rank 0's value to all. *Collective*.
void broadcast_shared(MPI_Comm comm, Shared& shared);

}  // namespace ritz::mesh
