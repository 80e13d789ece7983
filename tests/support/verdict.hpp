// The exit code of a test program.
#pragma once
#include <gtest/gtest.h>

namespace ritz::test {

/// 77, which says "skipped", where nothing failed because nothing was run; else `failed`.
inline int verdict(int failed) {
  const auto& all = *testing::UnitTest::GetInstance();
  return failed == 0 && all.skipped_test_count() > 0 && all.successful_test_count() == 0 ? 77 : failed;
}

}  // namespace ritz::test
