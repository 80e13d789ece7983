// Everything that a run of ritz-full leaves behind: full.h5, full.xdmf, the tables of its probes and, of a motion, of
// its energy; what its steps cost, when asked.
#pragma once
#include "ritz/app/full_file.hpp"
#include "ritz/app/full_timing.hpp"
#include "ritz/app/scene_loads.hpp"
#include "ritz/stages/full_dynamics.hpp"

namespace ritz::app {

/// Takes the states of a run one by one.
class FullRecorder {
 public:
  /// `frame_states` ascend, one for each of the plan's frame times. The problem must outlive it. *Collective*.
  FullRecorder(const config::Config& config, const scene::Scene& scene, const stages::Problem& problem,
               const FullPlan& plan, std::vector<std::int64_t> frame_states);

  /// The state that the run begins with. *Collective*.
  void start(const stages::DynamicState& state);
  /// The state that a step ends with. *Collective*.
  void step(const stages::DynamicState& state, const Effort& so_far);

  /// Stores `last` for a restart and brings all files to the disk. *Collective*.
  void finish(const stages::DynamicState& last, const std::string& problem_checksum);
  void publish();  ///< Gives them their names. *Collective*.

 private:
  void record(const stages::DynamicState& state);

  const mesh::Mesh& mesh_;
  const mesh::Dofs& dofs_;
  SceneProbes probes_;
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
