#include "ritz/scene/frames.hpp"

#include <algorithm>

namespace ritz::scene {

std::int64_t frame_count(const FrameChoice& choice, std::int64_t steps) {
  return choice.every ? steps / *choice.every + 1 : std::min(choice.frames.value_or(201), steps + 1);
}

std::vector<std::int64_t> frame_schedule(const FrameChoice& choice, std::int64_t steps) {
  std::vector<std::int64_t> states;
  if (choice.every) {
    for (std::int64_t state = 0; state <= steps; state += *choice.every) states.push_back(state);
    return states;
  }
  const std::int64_t frames = frame_count(choice, steps);
  if (frames == 1) return {steps};
  for (std::int64_t i = 0; i < frames; ++i)
    states.push_back(static_cast<std::int64_t>(static_cast<long double>(i) * steps / (frames - 1) + 0.5L));
  return states;
}

}  // namespace ritz::scene
