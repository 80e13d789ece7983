// Move-only owners of PETSc and SLEPc objects, which convert to the raw handles.
#pragma once
#include <petscksp.h>
#include <petscsf.h>
#include <petscsnes.h>
#include <slepceps.h>

#include <exception>
#include <type_traits>
#include <utility>

#include "ritz/algebra/check.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::algebra {

/// Whether a solver must not be destroyed because an exception was thrown on this rank alone: its factorization can
/// only be destroyed by all ranks together, and so it is left to the end of the process. Waits only seconds for the
/// other ranks.
template <class T>
bool left_alone(T object) {
  if constexpr (std::is_same_v<T, KSP> || std::is_same_v<T, SNES> || std::is_same_v<T, EPS>)
    return std::uncaught_exceptions() > 0 &&
           parallel::vote(PetscObjectComm(reinterpret_cast<PetscObject>(object)), false) == Vote::alone;
  return false;
}

/// Owns one reference and destroys it at the end; converts to the raw type for PETSc's own functions.
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

  /// The place into which a PETSc "create" function writes the new object; the previous object is destroyed first.
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

/// The communicator of a matrix.
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

}  // namespace ritz::algebra
