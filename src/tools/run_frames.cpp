#include "run_frames.hpp"

#include "ritz/scene/frames.hpp"

namespace ritz::tools {

std::int64_t frame_count(const RunOptions& options, std::int64_t steps) {
  return scene::frame_count({options.frames, options.every}, steps);
}

std::vector<std::int64_t> frame_schedule(const RunOptions& options, std::int64_t steps) {
  return scene::frame_schedule({options.frames, options.every}, steps);
}

}  // namespace ritz::tools
