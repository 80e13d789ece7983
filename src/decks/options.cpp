#include "options.hpp"

#include <CLI/CLI.hpp>

#include "ritz/base/error.hpp"
#include "ritz/readers/file_mesh.hpp"
#include "ritz/tools/command_line.hpp"

namespace ritz::decks {
namespace {

readers::Ignored words(const std::vector<std::string>& given) {
  readers::Ignored words;
  for (const auto& text : given) {
    words.push_back(readers::ignored_word(text));
    if (words.back().empty()) throw InputError("option --ignore: there is an empty word in the list");
  }
  return words;
}

}  // namespace

std::variant<Options, Help> parse_options(int argc, const char* const* argv) {
  Options options;
  std::string units = options.units.name;
  std::vector<std::string> ignored;
  CLI::App app("Takes the loads of a step of an Abaqus or CalculiX deck into a scene of ritz-run and ritz-full.",
               "ritz-scene");
  app.footer(
      "Example: ritz-scene part.inp --units mm-t-s --output part.toml\n"
      "Exit code: 0 done, 1 it could not be written, 2 the input is wrong.\n");
  app.get_formatter()->column_width(26);
  app.get_formatter()->label("REQUIRED", "");
  app.add_option("deck", options.deck, "The deck, which is also the mesh of ritz-reduce or\nritz-full")
      ->type_name("DECK.inp")
      ->required();
  app.add_option("--output", options.output, "Scene to write (default: print it)")->type_name("SCENE.toml");
  app.add_option("--units", units, "Units of the deck, as -units of ritz-reduce (default:\nm-kg-s); the scene is in SI")
      ->type_name("L-M-T");
  app.add_option("--ignore", ignored, "What to leave out on your word, as -ignore of\nritz-reduce: TIE,CENTRIF")
      ->type_name("WORD,...")
      ->allow_extra_args(false)
      ->delimiter(',');
  app.add_option("--step", options.step,
                 "The step, from 1 (default: the last that is *STATIC,\n*DYNAMIC or *MODAL DYNAMIC)")
      ->type_name("N");
  try {
    tools::parse(app, argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Help{app.help()};
  } catch (const CLI::CallForVersion& asked) {
    return Help{std::string(asked.what()) + "\n"};
  }
  options.units = readers::parse_units(units);
  options.ignored = words(ignored);
  return options;
}

}  // namespace ritz::decks
