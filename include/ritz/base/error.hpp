// The two ways a run of ritz can end badly, and what a program answers to each.
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

namespace ritz {

/// What stood in a method's way. A method knows no options and no files: it says what happened and why, and the program
/// adds which option or key of a scene its user can change (config/advice.hpp does for ritz-reduce and ritz-full).
enum class Reason : std::uint8_t {
  stated,                         ///< the message says all there is to say
  mode_absent,                    ///< a mode was chosen that is not among those computed
  too_few_modes_for_derivatives,  ///< derivatives of more modes are asked for than enter the basis
  nothing_spanned,                ///< the vectors that a basis is cut from are all zero
  too_few_directions,             ///< a basis of more columns is asked for than there are independent directions
  directions_lost,                ///< columns of a basis are dependent to rounding
  accuracy_out_of_reach,          ///< no basis of the modes given is as accurate as asked
  untestable_derivatives,         ///< rounding hides what modal derivatives are tested by
  beyond_double_precision,        ///< stiffness or mass are too large or too small to compute with
  modes_not_finite,               ///< the eigensolver returned numbers that are not finite
  modes_not_found,                ///< the direct eigensolver stopped before it had all modes
  tolerance_too_loose,            ///< modes meet the tolerance asked for, and not the gate on their residuals
  foreign_solver_inaccurate,      ///< modes of SLEPc's solver miss that gate
  foreign_solver_stopped,         ///< SLEPc's solver stopped before it had all modes
  iterative_solver_failed,        ///< an iterative solver does not converge, or not far enough
  memory_for_factors,             ///< the factors of a direct solver do not fit into memory
  workspace_for_factors,          ///< a direct solver needs more spare room than it was given
  rigid_motions,                  ///< statics of a body that its supports let move
  load_steps_too_large,           ///< statics do not converge, and nothing tells of a limit point
};

/// A message of one sentence that says what is wrong, where, and what to do, the last as far as the method knows it.
struct Error : std::runtime_error {
  explicit Error(const std::string& message, Reason why = Reason::stated) : std::runtime_error(message), reason(why) {}

  Reason reason;
};

/// The input is wrong: a file, an option, a set. Exit code 2.
struct InputError : Error {
  using Error::Error;
};

/// The numerics failed: a factorization, an iteration, memory. The message names the solve and its residual.
/// Exit code 1.
struct NumericalError : Error {
  using Error::Error;
};

inline constexpr int exit_done = 0;
inline constexpr int exit_numerical = 1;
inline constexpr int exit_input = 2;

}  // namespace ritz
