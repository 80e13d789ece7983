// ritz-run: its command line, and what it does.
#pragma once
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <variant>

#include "ritz/base/program.hpp"
#include "ritz/format/motion.hpp"
#include "ritz/world/run.hpp"

namespace ritz::tools {

/// Which forces the body has: the polynomial's where the model has one, or those of small displacements.
enum class Forces : unsigned char { stored, linear };

struct RunOptions {
  std::filesystem::path model;
  std::filesystem::path scene;  ///< empty when a mode is animated
  std::filesystem::path output = "motion.h5";
  std::filesystem::path restart;             ///< a motion to go on from; empty: the scene begins
  std::filesystem::path timing;              ///< a table of what each step cost; empty when none is wanted
  std::filesystem::path summary;             ///< what is printed, as JSON; empty when none is wanted
  std::optional<std::int64_t> animate_mode;  ///< from 1, all modes counted, rigid ones too
  std::optional<std::int64_t> frames;        ///< how many displacement frames, evenly spread
  std::optional<std::int64_t> every;         ///< a frame every so many steps
  format::Stored frame_numbers = format::Stored::float32;
  world::Precision precision = world::Precision::float64;  ///< of the nonlinear runtime
  Forces forces = Forces::stored;
  Voice voice = Voice::normal;
};

/// The text of --help, --help-scene or --version, when that was asked for.
struct Help {
  std::string text;
};

/// Throws InputError for a command line that is not as --help says, naming the nearest option.
std::variant<RunOptions, Help> parse_run_options(int argc, const char* const* argv);

/// Reads scene and model, runs, writes the motion, and says in one line on `out` what was done (unless quiet); warnings
/// go to `err`. Throws InputError and NumericalError; then no file is left behind or changed.
void run(const RunOptions& options, std::ostream& out, std::ostream& err);

}  // namespace ritz::tools
