// The two languages of options files: what they say, and what they cost when they are made to cost much.
#include "ritz/config/options_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ritz/base/error.hpp"

namespace ritz::config {

bool operator==(const Option& a, const Option& b) { return a.name == b.name && a.value == b.value; }

namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

void yaml_is_refused(const std::string& text, const std::string& first, const std::string& second = "") {
  EXPECT_THAT([&] { parse_yaml_options(text, "a.yaml"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(first), HasSubstr(second))))
      << text.substr(0, 80);
}

TEST(PlainOptions, KeepLongValuesWhole) {
  for (const std::size_t length : {4095, 4096, 200000}) {
    const std::string value(length, 'x');
    EXPECT_THAT(parse_plain_options("-fix " + value + "\n", "a.opts"), ElementsAre(Option{"fix", value}));
  }
}

TEST(PlainOptions, BeginAfterAByteOrderMark) {
  EXPECT_THAT(parse_plain_options("\xef\xbb\xbf-modes 2\r\n-quiet\r\n", "a.opts"),
              ElementsAre(Option{"modes", "2"}, Option{"quiet", ""}));
  EXPECT_THAT(parse_yaml_options("\xef\xbb\xbfmodes: 2\n", "a.yaml"), ElementsAre(Option{"modes", "2"}));
}

TEST(YamlOptions, AreFlatNestedAndListed) {
  EXPECT_THAT(parse_yaml_options(
                  "# ours\nmodes: 5\nmaterial: {young: 2e9, lid: {density: 10}}\nfix: [xmin, 'xmax:z']\n", "a.yaml"),
              ElementsAre(Option{"modes", "5"}, Option{"material_young", "2e9"}, Option{"material_lid_density", "10"},
                          Option{"fix", "xmin,xmax:z"}));
  EXPECT_THAT(parse_yaml_options("quiet:\n---\noutput: \"a b.h5\"\nfix:\n- a\n- b\n", "a.yaml"),
              ElementsAre(Option{"quiet", ""}, Option{"output", "a b.h5"}, Option{"fix", "a,b"}));
  EXPECT_THAT(parse_yaml_options("$$notes:\n  modes: [3, [1]]\n", "a.yaml"), ::testing::IsEmpty());
}

TEST(YamlOptions, AreEmptyInAnEmptyFile) {
  EXPECT_TRUE(parse_yaml_options("", "a.yaml").empty());
  EXPECT_TRUE(parse_yaml_options("# nothing\n---\n", "a.yaml").empty());
}

TEST(YamlOptions, KeepLongValuesWhole) {
  const std::string value(100000, 'x');
  EXPECT_THAT(parse_yaml_options("fix: " + value + "\n", "a.yaml"), ElementsAre(Option{"fix", value}));
}

TEST(YamlOptions, AreRefusedWhereTheyAreNoOptions) {
  yaml_is_refused("three modes\n", "a.yaml:1");
  yaml_is_refused("- modes\n", "a.yaml:1");
  yaml_is_refused("modes: 3\nfix: [[a]]\n", "a.yaml:2", "words and numbers");
  yaml_is_refused("[a, b]: 3\n", "a.yaml:1", "one word");
  yaml_is_refused("modes: 3\noptions_file: b.yaml\n", "a.yaml:2", "another");
  yaml_is_refused("material: {young: 3\n", "a.yaml", "not valid YAML");
}

TEST(YamlOptions, HaveNoAliases) {
  yaml_is_refused("a: &a {b: 1}\nc: *a\n", "a.yaml:2", "aliases");
  yaml_is_refused("modes: &m 3\nderivatives: *m\n", "a.yaml:2", "aliases");
}

TEST(YamlOptions, OfAnyDepthAreRefusedAtOnce) {
  constexpr int deep = 200000;
  for (const std::string start : {"", "modes: ", "$$a: "})
    for (const std::string nest : {"[", "{a: ", "- ", "? "}) yaml_is_refused(start + repeated(nest, deep), "a.yaml:1");
}

}  // namespace
}  // namespace ritz::config
