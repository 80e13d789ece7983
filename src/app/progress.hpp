// What a user sees of long work: a moving line on a terminal, dated lines elsewhere, nothing when asked for silence.
#pragma once
#include <mpi.h>

#include <chrono>
#include <string>
#include <vector>

#include "ritz/config/config.hpp"
#include "ritz/model/model.hpp"
#include "ritz/petsc/session.hpp"

namespace ritz::app {

/// Speaks on rank 0 alone; keeps the seconds of each stage for the report.
class Progress {
 public:
  Progress(MPI_Comm comm, config::Voice voice);

  /// Runs one stage of the pipeline: named in -log_view, timed, announced.
  template <class Work>
  auto stage(const std::string& name, Work work) {
    const petsc::LogStage log(name);
    const Timer timer(*this, name);
    return work();
  }

  /// How far the running stage is (0 ... 1).
  void update(const std::string& what, double fraction);
  void line(const std::string& text) const;  ///< to stdout
  void warn(const std::string& text);        ///< to stderr, and into the report; once

  const std::vector<model::StageTime>& seconds() const { return seconds_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  using Clock = std::chrono::steady_clock;

  struct Timer {
    Timer(Progress& p, const std::string& name);
    ~Timer();
    Progress& progress;
    std::string name;
    Clock::time_point start = Clock::now();
    int exceptions;
  };

  MPI_Comm comm_;
  bool speaks_ = false, terminal_ = false, root_ = false;
  std::string running_;
  Clock::time_point started_;
  std::vector<model::StageTime> seconds_;
  std::vector<std::string> warnings_;
};

}  // namespace ritz::app
