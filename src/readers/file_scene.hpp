// The analysis and the loads of a step of a deck, as a scene.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ritz/readers/file_mesh.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::readers {

/// What a deck says of loads, in the file's units: lengths, masses and times are those of its numbers. Sets and
/// vertices have the names and numbers that read_file gives them.
struct FileScene {
  scene::Scene scene;
  std::string step;                ///< "step 2 (*STATIC, FILE:LINE)"
  std::vector<std::string> notes;  ///< what the scene has not of the deck, or has otherwise: one sentence each
  std::vector<std::filesystem::path> files;  ///< all files that were read: the deck and those it includes
};

/// The scene of step number `step` (from 1), by default of the last *STATIC, *DYNAMIC or *MODAL DYNAMIC of an .inp
/// file.
///
/// A static step becomes statics, others a motion from rest. The loads are those that the step has in effect: its own,
/// and those of earlier steps that it neither changes (OP=MOD) nor removes (OP=NEW), as CalculiX has it. *CLOAD is a
/// force on every vertex; *DLOAD with P1 ... P6 and *DSLOAD with P are pressures, which push into the body where they
/// are positive; *DSLOAD with TRVEC is a traction; GRAV is gravity, or in a motion, where it changes, a shaking. A load
/// without *AMPLITUDE grows in proportion in a static step, and is there at once in others (*STEP, AMPLITUDE= tells
/// otherwise); an amplitude is a table, and one with DEFINITION=SMOOTH STEP a table of 50 intervals for each of its
/// own, which is off by at most 3e-4 of the step.
///
/// What changes the motion and has no counterpart in a scene is refused unless `ignored` has its word, and then noted.
/// Throws InputError, naming file and line.
FileScene read_scene(const std::filesystem::path& path, const Ignored& ignored = {}, std::optional<int> step = {});

}  // namespace ritz::readers
