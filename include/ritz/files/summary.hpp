// The members with which all summaries begin; see docs/summary.md.
#pragma once
#include <string>
#include <vector>

#include "ritz/files/json.hpp"

namespace ritz::files {

struct SummaryHead {
  std::string program;  ///< "ritz-run"
  int ranks = 1;
  std::string output;
  Json::Array stages;       ///< one object {"stage", "seconds"} for each stage
  double largest_rank = 0;  ///< the largest peak memory of a process, bytes
  double all_ranks = 0;     ///< the sum of the peak memories of all processes, bytes
  std::vector<std::string> warnings;
};

/// The members of a summary's head in order; a program appends its own.
Json::Object summary_head(const SummaryHead& head);

/// The peak memory of this process so far, bytes.
double peak_memory();

}  // namespace ritz::files
