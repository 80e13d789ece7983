// PETSc's error codes as exceptions.
#pragma once
#include <petscsys.h>

#include <cstdint>
#include <string>

namespace ritz::petsc {

/// Throws NumericalError with PETSc's own message when `code` is an error, std::bad_alloc when memory ran out.
void check(PetscErrorCode code);

/// Installs the handler that keeps PETSc's message for `check` in place of printing a stack trace.
void keep_messages();

/// Runs a call whose failure is expected and only of interest as yes or no.
bool succeeds(PetscErrorCode code);

/// Throws InputError, "`what`, more than ...", where PETSc's integers cannot count so many. The same on all ranks.
void refuse_beyond_index(const std::string& what, std::int64_t count);

}  // namespace ritz::petsc
