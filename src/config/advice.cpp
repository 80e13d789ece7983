#include "ritz/config/advice.hpp"

#include <utility>

#include "ritz/base/shown.hpp"

namespace ritz::config {
namespace {

/// What stands before and behind a message.
struct Advice {
  std::string about, remedy;
};

Advice advice(Reason reason, const Config& config) {
  switch (reason) {
    case Reason::stated: break;
    case Reason::mode_absent: return {"option -basis_modes: ", "; raise -modes"};
    case Reason::too_few_modes_for_derivatives:
      return {"option -derivatives " + std::to_string(config.basis->derivatives) + ": ", "; lower -derivatives"};
    case Reason::nothing_spanned: return {"", ": raise -modes or give -snapshots that move"};
    case Reason::too_few_directions:
      return {"option -basis " + std::to_string(config.basis->cut.size) + ": ",
              "; lower -basis, or raise -modes or -derivatives"};
    case Reason::directions_lost: return {"", "; lower -basis"};
    case Reason::accuracy_out_of_reach:
      return {"option -accuracy " + shown(config.accuracy->target) + ": ", "; raise -modes or the target"};
    case Reason::untestable_derivatives:
      return {"", "; leave out -derivatives, or use a mesh of better shape; the model was not written"};
    case Reason::beyond_double_precision: return {"", "; check lengths, materials and -units"};
    case Reason::modes_not_finite: return {"", "; check lengths, materials and -units, or use a mesh of better shape"};
    case Reason::modes_not_found: return {"", "; raise -modes_tolerance or lower -modes"};
    case Reason::tolerance_too_loose: return {"", "; choose a smaller -modes_tolerance"};
    case Reason::foreign_solver_inaccurate: return {"", "; leave out the options under -modes_eps_ and -modes_st_"};
    case Reason::foreign_solver_stopped: return {"", "; raise -modes_eps_max_it or -modes_eps_ncv"};
    case Reason::iterative_solver_failed: return {"", "; use -solver direct, or a mesh of better shape"};
    case Reason::memory_for_factors: return {"", "; use -solver iterative, or more machines"};
    case Reason::workspace_for_factors: return {"", "; give a larger -solve_mat_mumps_icntl_14, in percent"};
    case Reason::rigid_motions: return {"[static]: ", "; hold it with -fix, or let it move with [time]"};
    case Reason::load_steps_too_large: return {"", "; raise [static] steps"};
  }
  return {};
}

}  // namespace

std::string advised(const Error& error, const Config& config) {
  const auto [about, remedy] = advice(error.reason, config);
  return about + error.what() + remedy;
}

Work with_advice(Work work) {
  return [work = std::move(work)](MPI_Comm comm, const Config& config) {
    try {
      work(comm, config);
    } catch (const InputError& e) {
      throw InputError(advised(e, config));
    } catch (const NumericalError& e) {
      throw NumericalError(advised(e, config));
    }
  };
}

}  // namespace ritz::config
