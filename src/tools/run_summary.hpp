// What ritz-run prints, as numbers: --summary FILE.json, described in docs/summary.md.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ritz/files/json.hpp"
#include "ritz/world/run.hpp"
#include "run_body.hpp"
#include "run_options.hpp"

namespace ritz::tools {

/// What came of a body.
struct BodyResult {
  const RunBody& body;
  const world::RunResult& result;
  std::filesystem::path output;
  std::int64_t inverted_cells = 0;  ///< at the end, of the cells that frames show
};

struct Summarised {
  const RunOptions& options;
  const scene::Scene& scene;
  std::span<const BodyResult> bodies;
  std::int64_t frames = 0;
  const std::vector<std::string>& warnings;
};

files::Json summary(const Summarised& run);

}  // namespace ritz::tools
