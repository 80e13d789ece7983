// -help is the table of options: each with its default, and its unit or range where it is a number.
#include "ritz/config/option_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "config/configured.hpp"

namespace ritz::config {
namespace {

using ::testing::HasSubstr;

TEST(Help, ListsEveryOption) {
  const auto text = help_text("ritz-reduce");
  for (const auto& entry : option_table()) {
    EXPECT_THAT(text, HasSubstr("\n  -" + std::string(entry.name)));
    EXPECT_THAT(text, HasSubstr(std::string(entry.text)));
    EXPECT_THAT(text, HasSubstr(std::string(entry.unit)));
    EXPECT_THAT(text, HasSubstr(std::string(entry.fallback)));
    EXPECT_FALSE(entry.text.empty()) << entry.name;
  }
  for (const auto law : fem::law_names()) EXPECT_THAT(text, HasSubstr(" " + std::string(law)));
  EXPECT_THAT(text, HasSubstr("exit codes"));
}

TEST(Help, StatesDefaultsOfAllOptionsThatAreRead) {
  std::set<std::string_view> names;
  for (const auto& entry : option_table()) EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
  for (const auto& [name, value] : testing::with_box({}).resolved) {
    ASSERT_TRUE(names.contains(name)) << name;
    for (const auto& entry : option_table()) {
      const bool states_it = entry.name == name && !entry.fallback.empty() && !entry.argument.empty();
      if (states_it && name != "mesh") {
        EXPECT_EQ(entry.fallback, value) << name;
      }
    }
  }
}

}  // namespace
}  // namespace ritz::config
