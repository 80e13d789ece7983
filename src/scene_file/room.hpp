// Whether there is room for what a run would record.
#pragma once
#include <cstdint>
#include <filesystem>

namespace ritz::scene {

/// What a run records of each of its steps and of each frame.
struct Recording {
  std::int64_t steps = 0;
  std::int64_t frames = 0;
  double bytes_a_step = 0;
  double bytes_a_frame = 0;
};

/// Throws InputError, before any work, where a recording is larger than the free space of the folder that `output` is
/// written to, or its rows than `memory` bytes. Serial.
void refuse_beyond_room(const Recording& recording, const std::filesystem::path& output, double memory);

}  // namespace ritz::scene
