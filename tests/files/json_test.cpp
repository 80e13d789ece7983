// JSON as every parser reads it: nesting, escapes, numbers that read back as themselves.
#include "ritz/files/json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace ritz::files {
namespace {

std::string on_one_line(const Json& value) {
  std::string text = json_text(value);
  EXPECT_TRUE(text.ends_with('\n'));
  text.pop_back();
  return text;
}

TEST(Json, WritesNestedObjectsAndArrays) {
  const Json value = Json::Object{{"program", "ritz"},
                                  {"ranks", 2},
                                  {"empty", Json::Object{}},
                                  {"stages", Json::Array{Json::Object{{"stage", "mesh"}, {"seconds", .5}}}},
                                  {"size", Json::Array{1, 2.5, true, nullptr}}};
  EXPECT_EQ(json_text(value), R"({
  "program": "ritz",
  "ranks": 2,
  "empty": {},
  "stages": [
    {
      "stage": "mesh",
      "seconds": 0.5
    }
  ],
  "size": [1, 2.5, true, null]
}
)");
}

TEST(Json, WritesNumbersThatReadBackAsThemselves) {
  for (const double number : {.1, 1. / 3, 1e300, 5e-324, -0., std::nextafter(1., 2.), 6.02214076e23, 123456789.})
    EXPECT_EQ(std::strtod(on_one_line(number).c_str(), nullptr), number);
  EXPECT_EQ(on_one_line(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
}

TEST(Json, WritesNullForWhatIsNotFiniteOrNotThere) {
  for (const double number : {HUGE_VAL, -HUGE_VAL, std::nan("")}) EXPECT_EQ(on_one_line(number), "null");
  EXPECT_EQ(on_one_line(std::optional<double>()), "null");
  EXPECT_EQ(on_one_line(std::optional(1.5)), "1.5");
}

TEST(Json, EscapesWhatAStringMayNotHold) {
  EXPECT_EQ(on_one_line("a \"b\" \\ c"), R"("a \"b\" \\ c")");
  EXPECT_EQ(on_one_line(std::string("\n\t\x1b[2J\x7f\0", 8)), R"("\u000a\u0009\u001b[2J\u007f\u0000")");
  EXPECT_EQ(on_one_line("Gänge ∞ 𝄞"), "\"Gänge ∞ 𝄞\"");
  EXPECT_EQ(on_one_line("\xff"
                        "a\xc3"),
            R"("\ufffda\ufffd")");
  EXPECT_EQ(on_one_line(Json::Object{{"a\"b", 1}}), "{\n  \"a\\\"b\": 1\n}");
}

TEST(Json, ListsARange) {
  EXPECT_EQ(on_one_line(json_list(std::vector<double>{1.5, -2})), "[1.5, -2]");
  EXPECT_EQ(on_one_line(json_list(std::vector<std::string>{"a", "b"})), R"(["a", "b"])");
  EXPECT_EQ(on_one_line(json_list(std::vector<double>{})), "[]");
}

}  // namespace
}  // namespace ritz::files
