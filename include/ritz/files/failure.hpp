// Why a file could not be written, in words for the person who runs the program.
#pragma once
#include <string>

namespace ritz::files {

/// What `error`, a value of errno, means: "the disk is full", "the name is too long". 0: "is the disk full?", as who
/// failed did not say.
std::string why(int error);

/// Throws "cannot write WHAT: WHY; what to do", where WHAT is a path as a rule: InputError where another name or folder
/// helps (no such folder, no permission, a name too long), else NumericalError (a full disk, a quota, a limit).
[[noreturn]] void fail_to_write(const std::string& what, int error);

}  // namespace ritz::files
