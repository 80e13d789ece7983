// -help is the table of options: each with its default, and its unit or range where it is a number.
#include "ritz/config/option_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "config/configured.hpp"

namespace ritz::config {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr Program programs[] = {Program::reduce, Program::full};

/// The text with one blank in place of all that parts words.
std::string unwrapped(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::string line;
  for (std::string word; in >> word;) line += word + " ";
  return line;
}

std::set<std::string_view> names_of(Program program) {
  std::set<std::string_view> names;
  for (const auto& entry : option_table(program)) EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
  return names;
}

TEST(Help, ListsEveryOptionOfTheProgram) {
  for (const auto program : programs) {
    const auto text = help_text(program), line = unwrapped(text);
    for (const auto& entry : option_table(program)) {
      EXPECT_THAT(text, HasSubstr("\n  -" + std::string(entry.name)));
      EXPECT_THAT(line, HasSubstr(unwrapped(entry.text).substr(0, unwrapped(entry.text).size() - 1)));
      EXPECT_THAT(line, HasSubstr(std::string(entry.unit)));
      EXPECT_THAT(line, HasSubstr(std::string(entry.fallback)));
      EXPECT_FALSE(entry.text.empty()) << entry.name;
    }
    for (const auto law : fem::law_names()) EXPECT_THAT(text, HasSubstr(" " + std::string(law)));
    EXPECT_THAT(text, HasSubstr("\nExit codes"));
  }
}

TEST(Help, HasNoOptionOfTheOtherProgram) {
  const auto reduce = help_text(Program::reduce), full = help_text(Program::full);
  for (const auto* name : {"scene", "restart", "every"}) {
    EXPECT_THAT(reduce, Not(HasSubstr("\n  -" + std::string(name) + " "))) << name;
    EXPECT_THAT(full, HasSubstr("\n  -" + std::string(name) + " ")) << name;
  }
  for (const auto* name : {"modes", "derivatives", "polynomial", "plan"})
    EXPECT_THAT(full, Not(HasSubstr("\n  -" + std::string(name)))) << name;
}

TEST(Help, FitsATerminal) {
  for (const auto program : programs) {
    std::istringstream lines(help_text(program));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  }
}

TEST(Help, BeginsWithExamplesOfItsOwnOptions) {
  for (const auto program : programs) {
    const auto text = help_text(program);
    const auto start = text.find("\nExamples:\n"), end = text.find("\nThe mesh and what holds it:\n");
    ASSERT_LT(start, end);
    ASSERT_LT(end, text.size());
    const auto names = names_of(program);
    std::istringstream words(text.substr(start, end - start));
    int options = 0;
    for (std::string word; words >> word;) {
      if (word[0] != '-') continue;
      if (word == "-n") continue;  // mpirun's
      EXPECT_TRUE(names.contains(word.substr(1))) << word;
      ++options;
    }
    EXPECT_GT(options, 6);
  }
}

TEST(Help, NamesOfBothProgramsAreKnownOnce) {
  const auto names = option_names();
  const std::set<std::string_view> distinct(names.begin(), names.end());
  EXPECT_EQ(distinct.size(), names.size());
  for (const auto program : programs)
    for (const auto name : names_of(program)) EXPECT_TRUE(distinct.contains(name)) << name;
}

TEST(Help, StatesDefaultsOfAllOptionsThatAreRead) {
  const auto known = option_names();
  for (const auto& [name, value] : testing::with_box({}).resolved) {
    ASSERT_THAT(known, Contains(name));
    for (const auto& entry : option_table(Program::reduce)) {
      const bool states_it = entry.name == name && !entry.fallback.empty() && !entry.argument.empty();
      if (states_it && name != "mesh") {
        EXPECT_EQ(entry.fallback, value) << name;
      }
    }
  }
}

}  // namespace
}  // namespace ritz::config
