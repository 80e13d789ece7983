// MPI and PETSc on one rank, for targets that need them.
#pragma once
#include <slepcsys.h>

#include "ritz/mesh/dofs.hpp"
#include "ritz/mesh/read.hpp"
#include "ritz/petsc/check.hpp"

namespace ritz::fuzz {

/// As the programs start them, but that a signal stays what it is.
struct Setting {
  Setting() {
    if (SlepcInitializeNoArguments() != 0) std::abort();
    PetscPopSignalHandler();
    petsc::keep_messages();
  }
  ~Setting() { SlepcFinalize(); }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;
};

/// A free cube of eight vertices.
struct Cube {
  Setting setting;
  mesh::Mesh mesh =
      mesh::read(MPI_COMM_WORLD,
                 {.mesh = mesh::parse_box("box:1,1,1/1,1,1/hex8"), .units = {}, .ignored = {}, .vertex_lists = {}});
  mesh::Dofs dofs = mesh::number(mesh, {}, mesh::FileSupports::ignored);
};

}  // namespace ritz::fuzz
