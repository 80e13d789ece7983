// MPI and PETSc on one rank, for targets that need them.
#pragma once
#include "ritz/algebra/session.hpp"
#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/read.hpp"
#include "support/unwatched.hpp"

namespace ritz::fuzz {

inline algebra::Session start() {
  return test::unwatched([] { return algebra::Session("fuzz"); });
}

/// A free cube of eight vertices.
struct Cube {
  algebra::Session session = start();
  mesh::Mesh mesh = mesh::read(MPI_COMM_WORLD, {.mesh = mesh::parse_box("box:1,1,1/1,1,1/hex8"),
                                                .units = {},
                                                .partitioner = {},
                                                .ignored = {},
                                                .vertex_lists = {}});
  mesh::Dofs dofs = mesh::number(mesh, {}, mesh::FileSupports::ignored);
};

}  // namespace ritz::fuzz
