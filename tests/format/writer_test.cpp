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
    EXPECT_EQ(folder.files(), 1u);
    EXPECT_FALSE(std::filesystem::exists(folder / "model.h5"));
  }
  EXPECT_EQ(folder.files(), 0u);
}

TEST(Writer, LinksForParaView) {
  const Folder folder;
  for (int twice = 0; twice < 2; ++twice) write(folder / "model.h5", test::sample_model());
  EXPECT_EQ(std::filesystem::read_symlink(folder / "model.hdf"), "model.h5");
  EXPECT_EQ(folder.files(), 2u);
}

TEST(Writer, NeverReplacesARealFileByTheLink) {
  const Folder folder;
  test::save(folder / "model.hdf", test::Bytes(3));
  write(folder / "model.h5", test::sample_model());
  EXPECT_EQ(test::load(folder / "model.hdf").size(), 3u);
}

TEST(Writer, WritesThroughNoLink) {
  const Folder folder;
  test::save(folder / "kept", test::Bytes(3));
  std::filesystem::create_symlink("kept", folder / "model.h5.part");
  write(folder / "model.h5", test::sample_model());
  EXPECT_EQ(test::load(folder / "kept").size(), 3u);
  std::filesystem::create_symlink("kept", folder / "linked.h5");
  EXPECT_THAT([&] { ModelWriter(folder / "linked.h5"); }, ThrowsMessage<InputError>(HasSubstr("is a symbolic link")));
}

TEST(Writer, TwoAtOnceDoNotMix) {
  const Folder folder;
  ModelWriter one(folder / "model.h5");
  write(folder / "model.h5", test::sample_model());
  write_report(one, test::sample_report());
  EXPECT_NO_THROW(read(folder / "model.h5"));
  one.commit();
  EXPECT_THROW(read(folder / "model.h5"), InputError) << "the last to commit has its own file, a report alone";
}

TEST(Writer, KeepsASetWhoseNameHasAZeroByte) {
  const Folder folder;
  auto model = test::sample_model();
  using namespace std::string_literals;
  for (const auto& name : {"a\0b"s, "\0"s, "a%00b"s, "a"s}) {
    auto load = model.bodies[0].loads.front();
    load.set = name;
    model.bodies[0].loads.push_back(load);
  }
  write(folder / "model.h5", model);
  const auto back = read(folder / "model.h5");
  ASSERT_EQ(back.bodies[0].loads.size(), model.bodies[0].loads.size());
  for (std::size_t i = 0; i < back.bodies[0].loads.size(); ++i)
    EXPECT_EQ(back.bodies[0].loads[i].set, model.bodies[0].loads[i].set);
}

TEST(Writer, RefusesPlacesItCannotWriteTo) {
  const Folder folder;
  EXPECT_THAT([&] { ModelWriter(folder / "no/such/folder/model.h5"); },
              ThrowsMessage<InputError>(HasSubstr("there is no such folder")));
  std::filesystem::create_directory(folder / "model.h5");
  EXPECT_THAT([&] { ModelWriter(folder / "model.h5"); }, ThrowsMessage<InputError>(HasSubstr("it is a folder")));
  EXPECT_EQ(folder.files(), 1u);
}

}  // namespace
}  // namespace ritz::format
