// PETSc's error codes as exceptions.
#pragma once
#include <petscsys.h>

#include <cstdint>
#include <string>

namespace ritz::algebra {

/// Throws NumericalError with PETSc's own message when `code` is an error, and std::bad_alloc when it means that memory
/// ran out.
void check(PetscErrorCode code);

/// Installs the error handler that keeps PETSc's message for `check` instead of printing a stack trace.
void keep_messages();

/// Whether a call succeeded, for calls that are expected to fail.
bool succeeds(PetscErrorCode code);

/// Throws InputError, "`what`, more than ...", when `count` exceeds the range of PETSc's integers. `count` must be the
/// same on all ranks.
void refuse_beyond_index(const std::string& what, std::int64_t count);

}  // namespace ritz::algebra
