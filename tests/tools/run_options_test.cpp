#include "ritz/tools/run.hpp"

#include <gmock/gmock.h>

#include "ritz/base/error.hpp"
#include "ritz/scene_file/read.hpp"

namespace ritz::tools {
namespace {

using testing::HasSubstr;

std::variant<RunOptions, Help> parse(std::vector<const char*> words) {
  words.insert(words.begin(), "ritz-run");
  return parse_run_options(static_cast<int>(words.size()), words.data());
}

TEST(RunOptions, All) {
  const auto o = std::get<RunOptions>(
      parse({"model.h5", "--scene", "s.toml", "--output", "out/m.h5", "--every", "3", "--timing", "t.csv", "--quiet"}));
  EXPECT_EQ(o.model, "model.h5");
  EXPECT_EQ(o.scene, "s.toml");
  EXPECT_EQ(o.output, "out/m.h5");
  EXPECT_EQ(o.every, 3);
  EXPECT_FALSE(o.frames);
  EXPECT_EQ(o.timing, "t.csv");
  EXPECT_EQ(o.voice, Voice::quiet);
}

TEST(RunOptions, AMode) {
  const auto o = std::get<RunOptions>(parse({"model.h5", "--animate-mode", "7", "--frames", "12"}));
  EXPECT_EQ(o.animate_mode, 7);
  EXPECT_EQ(o.frames, 12);
  EXPECT_EQ(o.output, "motion.h5");
  EXPECT_EQ(o.voice, Voice::normal);
}

TEST(RunOptions, HelpNamesEveryOption) {
  EXPECT_EQ(std::get<Help>(parse({"--help-scene"})).text, scene::reference());
  EXPECT_THAT(std::get<Help>(parse({"--version"})).text, HasSubstr("ritz-run "));
  const auto help = std::get<Help>(parse({"--help"})).text;
  for (const auto* option : {"--scene", "--output", "--animate-mode", "--frames", "--every", "--timing", "--single",
                             "--linear", "--quiet", "--verbose"})
    EXPECT_THAT(help, HasSubstr(option));
}

TEST(RunOptions, BadLines) {
  const std::vector<std::pair<std::vector<const char*>, std::string>> bad = {
      {{}, "nothing to run"},
      {{"--animate-mode", "1"}, "give MODEL.h5"},
      {{"m.h5"}, "nothing to run"},
      {{"m.h5", "--scne", "s"}, "unknown option '--scne'; did you mean '--scene'?"},
      {{"--ouput", "s"}, "did you mean '--output'?"},
      {{"m.h5", "n.h5", "--scene", "s"}, "unexpected argument 'n.h5'"},
      {{"m.h5", "--scene"}, "--scene"},
      {{"m.h5", "--scene", "s", "--animate-mode", "1"}, "exclude each other"},
      {{"m.h5", "--scene", "s", "--frames", "1", "--every", "1"}, "exclude each other"},
      {{"m.h5", "--animate-mode", "1", "--every", "1"}, "--every needs a scene"},
      {{"m.h5", "--animate-mode", "1", "--timing", "t.csv"}, "--timing needs a scene"},
      {{"m.h5", "--scene", "s", "--quiet", "--verbose"}, "--quiet excludes --verbose"},
      {{"m.h5", "--animate-mode", "0"}, "--animate-mode: '0' is not a whole number from 1 on"},
      {{"m.h5", "--scene", "s", "--frames", "-1"}, "--frames: '-1' is not a whole number from 0 on"},
      {{"m.h5", "--scene", "s", "--every", "0"}, "--every: '0' is not"},
      {{"m.h5", "--scene", "s", "--every", "1.5"}, "--every: '1.5' is not"},
      {{"m.h5", "--scene", "s", "--every", "often"}, "--every: 'often' is not"},
  };
  for (const auto& [line, complaint] : bad) {
    try {
      parse(line);
      ADD_FAILURE() << "accepted, should say " << complaint;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(complaint));
      EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
    }
  }
}

}  // namespace
}  // namespace ritz::tools
