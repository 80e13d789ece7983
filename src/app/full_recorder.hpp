// The files of a run of ritz-full: full.h5, full.xdmf, the tables of its probes and (for a motion) of its energy, and
// the cost of its steps if requested.
#pragma once
#include <chrono>
#include <cstdint>

#include "ritz/app/full_file.hpp"
#include "ritz/app/outputs.hpp"
#include "ritz/app/scene_loads.hpp"
#include "ritz/stages/full_dynamics.hpp"

namespace ritz::app {

/// The effort since the run began.
struct Effort {
  std::int64_t iterations = 0;  ///< of Newton's method
  std::int64_t rejected = 0;    ///< steps, or load increments, that did not converge and were halved
};

/// Times steps by the clock of rank 0, as all ranks end a step together.
class FullTiming {
 public:
  FullTiming(MPI_Comm comm, const std::filesystem::path& path) : file_(comm, path) {}

  void begin_step();
  /// `t` is the time of the state reached, s (statics: the load fraction).
  void end_step(double t, const Effort& so_far);

  void finish() const;                 ///< *Collective*. Writes the table.
  void publish() { file_.publish(); }  ///< *Collective*. Renames the file to its final name.

 private:
  PendingFile file_;
  std::string rows_ = "t,microseconds,iterations,rejected\n";
  Effort before_;
  std::chrono::steady_clock::time_point begin_;
};

/// *Collective*. The acceleration of a state that is in balance with it, m/s².
using Balanced = std::function<mesh::FreeRows(const stages::DynamicState&)>;

/// Records the states of a run one by one.
class FullRecorder {
 public:
  /// *Collective*. `frame_states` are ascending, one for each frame time of the plan. Probes of accelerations, if there
  /// are any, measure what `acceleration` returns. The problem must outlive this object.
  FullRecorder(const config::Config& config, const scene::Scene& scene, const stages::Problem& problem,
               const FullPlan& plan, std::vector<std::int64_t> frame_states, Balanced acceleration);

  /// *Collective*. Records the state with which the run begins.
  void start(const stages::DynamicState& state);
  /// *Collective*. Records the state at the end of a step.
  void step(const stages::DynamicState& state, const Effort& so_far);

  /// *Collective*. Stores `last` for a restart and flushes all files to the disk.
  void finish(const stages::DynamicState& last, const std::string& problem_checksum);
  void publish();  ///< *Collective*. Renames the files to their final names.

 private:
  void record(const stages::DynamicState& state);

  const mesh::Mesh& mesh_;
  const mesh::Dofs& dofs_;
  SceneProbes probes_;
  Balanced acceleration_;
  FullFile file_;
  std::optional<PendingFile> probe_file_, energy_file_;
  std::optional<FullTiming> timing_;
  std::string integrator_;
  StateKind kind_;
  std::string probe_rows_, energy_rows_;
  std::vector<std::int64_t> frame_states_;
  std::size_t next_frame_ = 0;
  std::int64_t state_ = 0;
};

}  // namespace ritz::app
