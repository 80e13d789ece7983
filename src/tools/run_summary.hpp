// What ritz-run prints, as numbers: --summary FILE.json, described in docs/summary.md.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "ritz/files/json.hpp"
#include "ritz/world/run.hpp"
#include "run_options.hpp"

namespace ritz::tools {

struct Summarised {
  const RunOptions& options;
  const scene::Scene& scene;
  const model::Body& body;
  const world::RunResult& result;
  std::int64_t frames = 0;
  std::int64_t inverted_cells = 0;  ///< at the end, of the cells that frames show
  const std::vector<std::string>& warnings;
};

files::Json summary(const Summarised& run);

}  // namespace ritz::tools
