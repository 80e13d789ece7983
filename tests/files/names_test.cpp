#include "ritz/files/part_file.hpp"

#include <gtest/gtest.h>

namespace ritz::files {
namespace {

TEST(TableBeside, IsNamedAfterTheOutput) {
  EXPECT_EQ(table_beside("part.h5", "probes"), "part.probes.csv");
  EXPECT_EQ(table_beside("out/part.v2.h5", "energy"), "out/part.v2.energy.csv");
  EXPECT_EQ(table_beside("part", "probes"), "part.probes.csv");
}

TEST(TableBeside, IsPlainBesideTheDefaultOutputs) {
  EXPECT_EQ(table_beside("model.h5", "frequencies"), "frequencies.csv");
  EXPECT_EQ(table_beside("out/motion.h5", "probes"), "out/probes.csv");
  EXPECT_EQ(table_beside("/out/full.h5", "energy"), "/out/energy.csv");
  EXPECT_EQ(table_beside("models.h5", "frequencies"), "models.frequencies.csv");
}

}  // namespace
}  // namespace ritz::files
