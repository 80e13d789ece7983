#include "ritz/petsc/check.hpp"

#include <limits>

#include "ritz/base/error.hpp"

namespace ritz::petsc {
namespace {

/// PETSc reports an error through a callback before it returns the code: the first message of a chain is the cause.
std::string& last_message() {
  static std::string message;
  return message;
}

PetscErrorCode keep(MPI_Comm, int, const char* function, const char*, PetscErrorCode code, PetscErrorType type,
                    const char* message, void*) {
  if (type == PETSC_ERROR_INITIAL) last_message() = std::string(message ? message : "error") + " (in " + function + ")";
  return code;
}

}  // namespace

void keep_messages() { PetscPushErrorHandler(keep, nullptr); }

bool succeeds(PetscErrorCode code) {
  if (code == 0) return true;
  last_message().clear();
  return false;
}

void check(PetscErrorCode code) {
  if (code == 0) return;
  std::string message = last_message().empty() ? "error " + std::to_string(code) : last_message();
  last_message().clear();
  if (code == PETSC_ERR_MEM) message = "memory ran out: " + message;
  throw NumericalError("PETSc: " + message);
}

void refuse_beyond_index(const std::string& what, std::int64_t count) {
  constexpr std::int64_t most = std::numeric_limits<PetscInt>::max();
  if (count > most)
    throw InputError(what + ", more than the " + std::to_string(most) +
                     " that this PETSc's integers can count; use a PETSc with 64-bit indices");
}

}  // namespace ritz::petsc
