#include "room.hpp"

#include <limits>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"

namespace ritz::scene {

void refuse_beyond_room(const Recording& recording, const std::filesystem::path& output, double memory) {
  const double of_steps = static_cast<double>(recording.steps) * recording.bytes_a_step;
  const double of_frames = static_cast<double>(recording.frames) * recording.bytes_a_frame;
  std::error_code unknown;
  const auto folder = output.has_parent_path() ? output.parent_path() : std::filesystem::path(".");
  const auto space = std::filesystem::space(folder, unknown);
  const double free = unknown ? std::numeric_limits<double>::infinity() : static_cast<double>(space.available);
  if (of_steps + of_frames <= free && of_steps <= memory) return;
  const bool by_disk = of_steps + of_frames > free;
  throw InputError(shown(static_cast<double>(recording.steps)) + " steps and " +
                   shown(static_cast<double>(recording.frames)) + " frames would take " +
                   shown((by_disk ? of_steps + of_frames : of_steps) / 1e9, 3) + " GB of " +
                   (by_disk ? "the disk" : "memory") + ", of which " + shown((by_disk ? free : memory) / 1e9, 3) +
                   " GB are free: take longer steps, an earlier end, or fewer frames");
}

}  // namespace ritz::scene
