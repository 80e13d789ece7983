#include "run.hpp"

#include <CLI/CLI.hpp>

#include "command_line.hpp"
#include "ritz/base/error.hpp"
#include "ritz/scene_file/read.hpp"

namespace ritz::tools {
namespace {

/// A whole number that is not less than `least`.
auto at_least(std::int64_t least) {
  return [least](const std::string& text) -> std::string {
    std::int64_t value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= least) return {};
    return "'" + text + "' is not a whole number from " + std::to_string(least) + " on";
  };
}

void declare(CLI::App& app, RunOptions& options) {
  app.get_formatter()->column_width(26);
  app.get_formatter()->label("REQUIRED", "");
  app.add_option(
         "model", options.model,
         "Reduced model, as ritz-reduce writes it. May be left out\nwhere each [[body]] of the scene names its model")
      ->type_name("MODEL.h5");
  app.add_option("--scene", options.scene, "What is done to the body: time or statics, loads,\nprobes")
      ->type_name("SCENE.toml");
  app.add_option("--output", options.output,
                 "Motion to write (default: motion.h5). Beside it stand an\n"
                 ".xdmf for ParaView and, when the scene has probes, a\n"
                 "table: OTHER.probes.csv of OTHER.h5, and probes.csv of\nmotion.h5. A scene with [[body]] NAME "
                 "writes\nmotion.NAME.h5 for each")
      ->type_name("MOTION.h5");
  app.add_option("--restart", options.restart,
                 "Go on from the last state of an earlier run of the same\n"
                 "scene, whose 'end' is later now, as if it had not\n"
                 "stopped. The motion and the probes begin there. Of a\n"
                 "scene with [[body]] NAME it is MOTION.NAME.h5 of each")
      ->type_name("MOTION.h5");
  app.add_option("--animate-mode", options.animate_mode,
                 "Instead of a scene, swing mode I through one period, at\n"
                 "a tenth of the body's size. I is the index of the\n"
                 "model's table of frequencies: from 1, rigid modes\ncounted too")
      ->type_name("I")
      ->check(at_least(1));
  app.add_option("--frames", options.frames,
                 "Number of displacement frames, spread evenly over the\n"
                 "run; 0 writes reduced coordinates and probes only\n"
                 "(default: every step, at most 201; of a mode 40)")
      ->type_name("N")
      ->check(at_least(0));
  app.add_option("--every", options.every, "Write a frame every N steps")->type_name("N")->check(at_least(1));
  app.add_flag_callback(
      "--double-frames", [&] { options.frame_numbers = format::Stored::float64; },
      "Write the frames in double precision (default: single;\ncoordinates and probes are always double)");
  app.add_option("--timing", options.timing, "Write what each step cost, without recording, as a table")
      ->type_name("FILE.csv");
  app.add_option("--summary", options.summary, "Write what is printed, as numbers: docs/summary.md")
      ->type_name("FILE.json");
  app.add_flag_callback(
      "--single", [&] { options.precision = world::Precision::float32; },
      "Compute in single precision (nonlinear models only)");
  app.add_flag_callback(
      "--linear", [&] { options.forces = Forces::linear; },
      "Small displacements: leave a model's polynomial unread and\nrun its linear part");
  auto* quiet = app.add_flag_callback(
      "--quiet", [&] { options.voice = Voice::quiet; }, "Print nothing but warnings and errors");
  app.add_flag_callback(
         "--verbose", [&] { options.voice = Voice::verbose; }, "Print what the steps took, too: Newton's iterations")
      ->excludes(quiet);
}

void refuse_contradictions(const RunOptions& options) {
  if (options.scene.empty() && !options.animate_mode)
    throw InputError("nothing to run: give --scene SCENE.toml or --animate-mode I");
  if (options.model.empty() && options.animate_mode)
    throw InputError("--animate-mode swings a mode of a model: give MODEL.h5");
  if (!options.scene.empty() && options.animate_mode)
    throw InputError("--scene and --animate-mode exclude each other: a mode swings without a scene");
  if (options.frames && options.every) throw InputError("--frames and --every exclude each other: keep one of them");
  if (!options.timing.empty() && options.animate_mode)
    throw InputError("--timing needs a scene: a mode swings without steps");
  if (!options.restart.empty() && options.animate_mode)
    throw InputError("--restart needs a scene: a mode swings without steps");
  if (!options.summary.empty() && options.animate_mode)
    throw InputError("--summary needs a scene: a mode swings without steps");
  if (options.every && options.animate_mode) throw InputError("--every needs a scene: for a mode say --frames N");
}

}  // namespace

std::variant<RunOptions, Help> parse_run_options(int argc, const char* const* argv) {
  RunOptions options;
  CLI::App app("Runs a scene on a reduced model: integrates it in time or solves its statics, and writes the motion.",
               "ritz-run");
  app.footer(
      "Example: ritz-run model.h5 --scene scene.toml --output motion.h5\n"
      "Exit code: 0 done, 1 the numerics failed, 2 the input is wrong.\n");
  declare(app, options);
  bool of_scenes = false;
  app.add_flag("--help-scene", of_scenes, "Print a scene with every key, its unit and its default, and exit");
  try {
    parse(app, argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Help{app.help()};
  } catch (const CLI::CallForVersion& asked) {
    return Help{std::string(asked.what()) + "\n"};
  }
  if (of_scenes) return Help{std::string(scene::reference())};
  refuse_contradictions(options);
  return options;
}

}  // namespace ritz::tools
