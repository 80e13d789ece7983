// The main of serial tests.
#include <gmock/gmock.h>

#include "support/verdict.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  return ritz::test::verdict(RUN_ALL_TESTS());
}
