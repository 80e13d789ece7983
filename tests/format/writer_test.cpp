#include "ritz/format/writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "format/temporary.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/parts.hpp"
#include "support/sample_model.hpp"

namespace ritz::format {
namespace {

using test::Folder;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Writer, LeavesNothingUncommitted) {
  const Folder folder;
  {
    ModelWriter out(folder / "model.h5");
    write_report(out, test::sample_report());
    EXPECT_TRUE(std::filesystem::exists(folder / "model.h5.part"));
    EXPECT_FALSE(std::filesystem::exists(folder / "model.h5"));
  }
  EXPECT_EQ(folder.files(), 0u);
}

TEST(Writer, LinksForParaView) {
  const Folder folder;
  for (int twice = 0; twice < 2; ++twice) write(folder / "model.h5", test::sample_model());
  EXPECT_EQ(std::filesystem::read_symlink(folder / "model.vtkhdf"), "model.h5");
  EXPECT_EQ(folder.files(), 2u);
}

TEST(Writer, NeverReplacesARealFileByTheLink) {
  const Folder folder;
  test::save(folder / "model.vtkhdf", test::Bytes(3));
  write(folder / "model.h5", test::sample_model());
  EXPECT_EQ(test::load(folder / "model.vtkhdf").size(), 3u);
}

TEST(Writer, RefusesPlacesItCannotWriteTo) {
  const Folder folder;
  EXPECT_THAT([&] { ModelWriter(folder / "no/such/folder/model.h5"); },
              ThrowsMessage<InputError>(HasSubstr("No such file or directory")));
  std::filesystem::create_directory(folder / "model.h5");
  EXPECT_THAT([&] { ModelWriter(folder / "model.h5"); }, ThrowsMessage<InputError>(HasSubstr("Is a directory")));
  EXPECT_EQ(folder.files(), 1u);
}

}  // namespace
}  // namespace ritz::format
