// Which states of a run become displacement frames.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

namespace ritz::scene {

/// What a user asked for; nothing: all states up to 201 frames.
struct FrameChoice {
  std::optional<std::int64_t> frames;  ///< how many, evenly spread
  std::optional<std::int64_t> every;   ///< or one every so many steps
};

/// How many frames that makes.
std::int64_t frame_count(const FrameChoice& choice, std::int64_t steps);

/// States are numbered 0 ... steps. Ascending: every so-many-th, or the asked number of frames spread evenly with the
/// first and the last state among them (a single frame is the last), or by default all up to 201 frames.
std::vector<std::int64_t> frame_schedule(const FrameChoice& choice, std::int64_t steps);

}  // namespace ritz::scene
