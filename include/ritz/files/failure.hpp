// Says why a file could not be written, in words for the user.
#pragma once
#include <string>

namespace ritz::files {

/// What `error`, a value of errno, means: "the disk is full", "the name is too long". For 0, an unknown error: "is the
/// disk full?".
std::string why(int error);

/// Throws "cannot write WHAT: WHY; what to do", where WHAT is usually a path: InputError where another name or folder
/// would help (no such folder, no permission, a name too long), else NumericalError (a full disk, a quota, a limit).
[[noreturn]] void fail_to_write(const std::string& what, int error);

}  // namespace ritz::files
