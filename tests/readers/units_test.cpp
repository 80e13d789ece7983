// Unit systems against steel, whose properties everyone knows in several.
#include "ritz/readers/units.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ritz/base/error.hpp"

namespace ritz::readers {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

void expect_steel(const char* units, double young, double density) {
  const FileMaterial steel = parse_units(units).to_si({young, 0.29, density});
  EXPECT_NEAR(*steel.young / 206e9, 1, 1e-14) << units;
  EXPECT_EQ(steel.poisson, 0.29);
  EXPECT_NEAR(*steel.density / 7850, 1, 1e-14) << units;
}

TEST(Units, TurnSteelIntoSi) {
  expect_steel("m-kg-s", 206e9, 7850);
  expect_steel("mm-t-s", 206e3, 7.85e-9);
  expect_steel("mm-kg-ms", 206, 7.85e-6);
  expect_steel("cm-g-s", 206e10, 7.85);
  expect_steel("um-kg-s", 206e3, 7.85e-15);
}

TEST(Units, KnowTheirLengths) {
  EXPECT_EQ(parse_units("mm-t-s").length, 1e-3);
  EXPECT_EQ(parse_units("in-kg-s").length, 0.0254);
}

TEST(Units, RefuseUnknownWords) {
  for (const char* text : {"", "mm", "mm-t", "mm-t-s-K", "mm-t-h", "MM-t-s", "yd-kg-s", "mm--s"})
    EXPECT_THAT([&] { parse_units(text); }, ThrowsMessage<InputError>(HasSubstr(std::string("-units ") + text)))
        << text;
}

}  // namespace
}  // namespace ritz::readers
