// Owners of PETSc and SLEPc objects: move-only, the raw handle reachable; and whose they are.
#pragma once
#include <petscksp.h>
#include <petscsf.h>
#include <petscsnes.h>
#include <slepceps.h>

#include <exception>
#include <type_traits>
#include <utility>

#include "ritz/parallel/comm.hpp"
#include "ritz/petsc/check.hpp"

namespace ritz::petsc {

/// Whether an exception that this rank alone has thrown passes by a solver, whose factorization can be destroyed by all
/// ranks together only: it is left to the end of the process then. Waits for the other ranks for seconds.
template <class T>
bool left_alone(T object) {
  if constexpr (std::is_same_v<T, KSP> || std::is_same_v<T, SNES> || std::is_same_v<T, EPS>)
    return std::uncaught_exceptions() > 0 &&
           parallel::vote(PetscObjectComm(reinterpret_cast<PetscObject>(object)), false) == Vote::alone;
  return false;
}

/// Owns one reference. Copies are not made; the handle converts to the raw type for PETSc's own functions.
template <class T, PetscErrorCode (*destroy)(T*)>
class Handle {
 public:
  Handle() = default;
  Handle(Handle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  ~Handle() {
    if (object_ && !left_alone(object_)) destroy(&object_);
  }

  operator T() const { return object_; }
  T get() const { return object_; }

  /// Where a PETSc "create" function puts the new object; what was held is destroyed first.
  T* out() {
    if (object_) destroy(&object_);
    return &object_;
  }

 private:
  T object_ = nullptr;
};

/// The preconditioner that `ksp` owns.
inline PC preconditioner(KSP ksp) {
  PC pc = nullptr;
  check(KSPGetPC(ksp, &pc));
  return pc;
}

/// The ranks that share a matrix.
inline MPI_Comm comm_of(Mat A) { return PetscObjectComm(reinterpret_cast<PetscObject>(A)); }

using Matrix = Handle<Mat, MatDestroy>;
using Vector = Handle<Vec, VecDestroy>;
using Solver = Handle<KSP, KSPDestroy>;
using NonlinearSolver = Handle<SNES, SNESDestroy>;
using StarForest = Handle<PetscSF, PetscSFDestroy>;
using Preconditioner = Handle<PC, PCDestroy>;
using EigenSolver = Handle<EPS, EPSDestroy>;
using IndexSet = Handle<IS, ISDestroy>;
using NullSpace = Handle<MatNullSpace, MatNullSpaceDestroy>;
using Scatter = Handle<VecScatter, VecScatterDestroy>;
using Container = Handle<PetscContainer, PetscContainerDestroy>;
using Viewer = Handle<PetscViewer, PetscViewerDestroy>;

}  // namespace ritz::petsc
