#include "run_frames.hpp"

#include "ritz/scene/frames.hpp"

namespace ritz::tools {

std::vector<std::int64_t> frame_schedule(const RunOptions& options, std::int64_t steps) {
  return scene::frame_schedule({options.frames, options.every}, steps);
}

}  // namespace ritz::tools
