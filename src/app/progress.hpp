// Shows the progress of long work: a line that is overwritten on a terminal, dated lines elsewhere, nothing if the user
// asked for silence.
#pragma once
#include <mpi.h>

#include <chrono>
#include <string>
#include <vector>

#include "ritz/algebra/session.hpp"
#include "ritz/base/program.hpp"
#include "ritz/config/config.hpp"
#include "ritz/model/model.hpp"

namespace ritz::app {

/// Prints on rank 0 alone. Records the time of each stage for the report.
class Progress {
 public:
  Progress(MPI_Comm comm, Voice voice);

  /// Runs one stage of the pipeline, and names it in -log_view, times it and announces it.
  template <class Work>
  auto stage(const std::string& name, Work work) {
    const algebra::LogStage log(name);
    const Timer timer(*this, name);
    return work();
  }

  /// Sets the progress of the running stage, 0 ... 1.
  void update(const std::string& what, double fraction);
  void line(const std::string& text) const;  ///< prints on stdout
  void warn(const std::string& text);        ///< prints on stderr, once, and records it in the report

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
