// The two ways a run of ritz can end badly, and what a program answers to each.
#pragma once
#include <stdexcept>
#include <string>

namespace ritz {

/// The input is wrong: a file, an option, a set. The message is one sentence that says what is wrong, where, and what
/// to do. Exit code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The numerics failed: a factorization, an iteration, memory. The message names the solve and its residual.
/// Exit code 1.
struct NumericalError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr int exit_done = 0;
inline constexpr int exit_numerical = 1;
inline constexpr int exit_input = 2;

}  // namespace ritz
