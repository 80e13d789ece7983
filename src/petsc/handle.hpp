// Owners of PETSc and SLEPc objects: move-only, the raw handle reachable; and whose they are.
#pragma once
#include <petscksp.h>
#include <petscsf.h>
#include <petscsnes.h>
#include <slepceps.h>

#include <utility>

namespace ritz::petsc {

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
    if (object_) destroy(&object_);
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
