// MPI and PETSc on one rank, for targets that need them.
#pragma once
#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/read.hpp"
#include "ritz/petsc/session.hpp"
#include "support/unwatched.hpp"

namespace ritz::fuzz {

inline petsc::Session start() {
  return test::unwatched([] { return petsc::Session("fuzz"); });
}

/// A free cube of eight vertices.
struct Cube {
  petsc::Session session = start();
  mesh::Mesh mesh = mesh::read(MPI_COMM_WORLD, {.mesh = mesh::parse_box("box:1,1,1/1,1,1/hex8"),
                                                .units = {},
                                                .partitioner = {},
                                                .ignored = {},
                                                .vertex_lists = {}});
  mesh::Dofs dofs = mesh::number(mesh, {}, mesh::FileSupports::ignored);
};

}  // namespace ritz::fuzz
