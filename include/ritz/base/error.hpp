// The two kinds of error, and the exit code of a program for each.
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

namespace ritz {

/// What made a method fail. A method knows neither options nor files: it says what happened and why, and the program
/// adds which option or scene key the user can change (for ritz-reduce and ritz-full in config/advice.hpp).
enum class Reason : std::uint8_t {
  stated,                         ///< the message is complete
  mode_absent,                    ///< a chosen mode is not among those computed
  too_few_modes_for_derivatives,  ///< derivatives are requested for more modes than enter the basis
  nothing_spanned,                ///< the vectors from which a basis is made are all zero
  too_few_directions,             ///< a basis of more columns is requested than there are independent vectors
  directions_lost,                ///< columns of a basis are linearly dependent up to rounding errors
  accuracy_out_of_reach,          ///< no basis of the given modes is as accurate as requested
  untestable_derivatives,         ///< rounding errors hide the remainder by which modal derivatives are tested
  beyond_double_precision,        ///< stiffness or mass are too large or too small for double precision
  modes_not_finite,               ///< the eigensolver returned numbers that are not finite
  modes_not_found,                ///< the direct eigensolver stopped before it had found all modes
  tolerance_too_loose,            ///< modes meet the requested tolerance, but not the bound on their residuals
  foreign_solver_inaccurate,      ///< modes of SLEPc's solver do not meet that bound
  foreign_solver_stopped,         ///< SLEPc's solver stopped before it had found all modes
  iterative_solver_failed,        ///< an iterative solver did not converge, or not far enough
  memory_for_factors,             ///< the factors of a direct solver do not fit into memory
  workspace_for_factors,          ///< a direct solver needs more workspace than it was given
  rigid_motions,                  ///< statics of a body whose supports leave rigid motions free
  load_steps_too_large,           ///< statics did not converge, and there is no sign of a limit point
};

/// The message is one sentence that says what is wrong, where, and what to do (the last as far as the method knows it).
struct Error : std::runtime_error {
  explicit Error(const std::string& message, Reason why = Reason::stated) : std::runtime_error(message), reason(why) {}

  Reason reason;
};

/// The input is wrong, such as a file, an option or the name of a set. Exit code 2.
struct InputError : Error {
  using Error::Error;
};

/// The computation failed, such as a factorization, an iteration or an allocation. The message names the solve and its
/// residual. Exit code 1.
struct NumericalError : Error {
  using Error::Error;
};

inline constexpr int exit_done = 0;
inline constexpr int exit_numerical = 1;
inline constexpr int exit_input = 2;

}  // namespace ritz
