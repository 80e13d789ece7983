#include "ritz/base/shown.hpp"

#include <gtest/gtest.h>

namespace ritz {

TEST(Counted, ThingsAreOneOrMany) {
  EXPECT_EQ(counted(0, "vertex", "vertices"), "0 vertices");
  EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
  EXPECT_EQ(counted(5'000'000'000, "vertex", "vertices"), "5000000000 vertices");
}

}  // namespace ritz
