#include "ritz/files/summary.hpp"

#include <sys/resource.h>

#include "ritz/base/program.hpp"

namespace ritz::files {

Json::Object summary_head(const SummaryHead& head) {
  return {{"format", "ritz-summary"},
          {"version", 1},
          {"program", head.program},
          {"program_version", version},
          {"ranks", head.ranks},
          {"output", head.output},
          {"stages", head.stages},
          {"memory", Json::Object{{"largest_rank", head.largest_rank}, {"all_ranks", head.all_ranks}}},
          {"warnings", json_list(head.warnings)}};
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace ritz::files
