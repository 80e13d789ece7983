// What the summaries of all programs begin with: docs/summary.md.
#pragma once
#include <string>
#include <vector>

#include "ritz/files/json.hpp"

namespace ritz::files {

struct SummaryHead {
  std::string program;  ///< "ritz-run"
  int ranks = 1;
  std::string output;
  Json::Array stages;       ///< {"stage", "seconds"} of each
  double largest_rank = 0;  ///< the most memory that a process held, bytes
  double all_ranks = 0;     ///< the sum over the processes, bytes
  std::vector<std::string> warnings;
};

/// Its members in their order, to which a program appends its own.
Json::Object summary_head(const SummaryHead& head);

/// The most memory that this process has held so far, bytes.
double peak_memory();

}  // namespace ritz::files
