#include "ritz/algebra/check.hpp"

#include <limits>
#include <new>
#include <string_view>
#include <utility>

#include "ritz/base/error.hpp"

namespace ritz::algebra {
namespace {

/// PETSc reports an error through a callback before it returns a code: the first of a chain is the cause.
struct Cause {
  bool memory = false;
  std::string message;
};

/// PETSc 3.18 gives its own failed malloc another code.
bool lacks_memory(PetscErrorCode code, std::string_view function) {
  return code == PETSC_ERR_MEM || function == "PetscMallocAlign";
}

Cause& last_cause() {
  static Cause cause;
  return cause;
}

PetscErrorCode keep(MPI_Comm, int, const char* function, const char*, PetscErrorCode code, PetscErrorType type,
                    const char* message, void*) {
  if (type != PETSC_ERROR_INITIAL) return code;
  Cause& cause = last_cause();
  cause.memory = lacks_memory(code, function);
  if (!cause.memory) cause.message = std::string(message ? message : "error") + " (in " + function + ")";
  return code;
}

}  // namespace

void keep_messages() { PetscPushErrorHandler(keep, nullptr); }

bool succeeds(PetscErrorCode code) {
  if (code == 0) return true;
  last_cause() = {};
  return false;
}

void check(PetscErrorCode code) {
  if (code == 0) return;
  const Cause cause = std::exchange(last_cause(), {});
  if (cause.memory || code == PETSC_ERR_MEM) throw std::bad_alloc();
  throw NumericalError("PETSc: " + (cause.message.empty() ? "error " + std::to_string(code) : cause.message));
}

void refuse_beyond_index(const std::string& what, std::int64_t count) {
  constexpr std::int64_t most = std::numeric_limits<PetscInt>::max();
  if (count > most)
    throw InputError(what + ", more than the " + std::to_string(most) +
                     " that this PETSc's integers can count; use a PETSc with 64-bit indices");
}

}  // namespace ritz::algebra
