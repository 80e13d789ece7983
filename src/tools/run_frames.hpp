// Which states of a run become displacement frames.
#pragma once
#include <cstdint>
#include <vector>

#include "run_options.hpp"

namespace ritz::tools {

/// How many frames that makes.
std::int64_t frame_count(const RunOptions& options, std::int64_t steps);

/// States are numbered 0 ... steps. Ascending: every so-many-th, or the asked number of frames spread evenly with the
/// first and the last state among them (a single frame is the last), or by default all up to 201 frames.
std::vector<std::int64_t> frame_schedule(const RunOptions& options, std::int64_t steps);

}  // namespace ritz::tools
