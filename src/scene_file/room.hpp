// Checks before a run that there is space for what it would record.
#pragma once
#include <cstdint>
#include <filesystem>

namespace ritz::scene {

/// The size of what a run records for each of its steps and frames.
struct Recording {
  std::int64_t steps = 0;
  std::int64_t frames = 0;
  double bytes_a_step = 0;
  double bytes_a_frame = 0;
};

/// Throws InputError, before any work, when a recording is larger than the free space of the folder of `output`, or its
/// rows larger than `memory` bytes. Serial.
void refuse_beyond_room(const Recording& recording, const std::filesystem::path& output, double memory);

}  // namespace ritz::scene
