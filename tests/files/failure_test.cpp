#include "ritz/files/part_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <set>

#include "ritz/base/error.hpp"

namespace ritz::files {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Failure, HasAReasonForEachErrorOfADisk) {
  std::set<std::string> reasons;
  const int errors[] = {ENOSPC, EDQUOT, EFBIG,  EROFS,   EACCES, ENAMETOOLONG,
                        EMFILE, EIO,    ENOENT, ENOTDIR, EISDIR, ELOOP};
  for (const int error : errors) reasons.insert(why(error));
  EXPECT_EQ(reasons.size(), std::size(errors));
  EXPECT_THAT(why(ESTALE), HasSubstr("tale")) << "the system's own words for all others";
}

TEST(Failure, TellsTheUsersMistakesFromTheDisks) {
  EXPECT_THAT([] { fail_to_write("a.h5", EACCES); },
              ThrowsMessage<InputError>(HasSubstr("cannot write a.h5: permission is denied")));
  EXPECT_THAT([] { fail_to_write("a.h5", EROFS); }, ThrowsMessage<InputError>(HasSubstr("read-only")));
  EXPECT_THAT([] { fail_to_write("a.h5", ENOSPC); }, ThrowsMessage<NumericalError>(HasSubstr("the disk is full")));
  EXPECT_THAT([] { fail_to_write("a.h5", EDQUOT); }, ThrowsMessage<NumericalError>(HasSubstr("quota")));
}

}  // namespace
}  // namespace ritz::files
