// Which states of a run are stored as displacement frames.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

namespace ritz::scene {

/// What the user asked for; if neither member is set: all states, but at most 201 frames.
struct FrameChoice {
  std::optional<std::int64_t> frames;  ///< the number of frames, evenly spread
  std::optional<std::int64_t> every;   ///< one frame every so many steps
};

/// The number of frames of a run of `steps` steps.
std::int64_t frame_count(const FrameChoice& choice, std::int64_t steps);

/// The states that are frames, ascending; states are numbered 0 ... steps. With `every`: 0, every, 2 every, ...; with
/// `frames`: so many, spread evenly from the first state to the last (a single frame is the last state); by default as
/// with `frames` = 201, or all states if there are fewer.
std::vector<std::int64_t> frame_schedule(const FrameChoice& choice, std::int64_t steps);

}  // namespace ritz::scene
