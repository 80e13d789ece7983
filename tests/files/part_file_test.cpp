#include "ritz/files/part_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "files/folder.hpp"
#include "ritz/base/error.hpp"

namespace ritz::files {
namespace {

using test::Folder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(PartFile, TakesItsNameWhenItIsPublished) {
  const Folder folder;
  for (const std::string text : {"first", "second, over it"}) {
    PartFile file(folder / "a.csv");
    EXPECT_EQ(file.part().parent_path(), file.path().parent_path()) << "else a rename could not be atomic";
    EXPECT_EQ(file.part().extension(), ".part");
    file.write("something longer that is written over");
    file.write(text);
    file.finish();
    if (text == "first") EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
    else EXPECT_EQ(test::load(folder / "a.csv"), "first");
    file.publish();
    EXPECT_EQ(test::load(folder / "a.csv"), text);
  }
  EXPECT_EQ(folder.files(), 1);
}

TEST(PartFile, IsGoneWhenItIsNot) {
  const Folder folder;
  test::save(folder / "a.csv", "earlier");
  { PartFile(folder / "a.csv").write("half"); }
  {
    PartFile one(folder / "a.csv");
    const PartFile moved(std::move(one));
    EXPECT_EQ(folder.files(), 2);
  }
  EXPECT_EQ(folder.files(), 1);
  EXPECT_EQ(test::load(folder / "a.csv"), "earlier");
}

TEST(PartFile, HasANameOfItsOwn) {
  const Folder folder;
  PartFile one(folder / "a.csv"), other(folder / "a.csv");
  one.write("one");
  other.write("other");
  one.publish();
  EXPECT_EQ(test::load(folder / "a.csv"), "one");
  other.publish();
  EXPECT_EQ(test::load(folder / "a.csv"), "other");
}

TEST(PartFile, ServesTheLongestNames) {
  const Folder folder;
  for (const std::size_t length : {230, 240, 255}) {
    PartFile file(folder / std::string(length, 'x'));
    file.publish();
  }
  EXPECT_EQ(folder.files(), 3);
  EXPECT_THAT([&] { PartFile(folder / std::string(256, 'x')); },
              ThrowsMessage<InputError>(HasSubstr("the name is too long")));
}

TEST(PartFile, RefusesWhatIsNoPlainFile) {
  const Folder folder;
  std::filesystem::create_directory(folder / "folder");
  std::filesystem::create_symlink("a.csv", folder / "link");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const std::pair<std::filesystem::path, std::string> bad[] = {{folder / "folder", "it is a folder"},
                                                               {folder / "link", "it is a symbolic link"},
                                                               {folder / "pipe", "it is a named pipe"},
                                                               {"/dev/null", "it is a device"},
                                                               {folder / "none/a.csv", "there is no such folder"}};
  for (const auto& [path, what] : bad)
    EXPECT_THAT([&] { PartFile{path}; }, ThrowsMessage<InputError>(AllOf(HasSubstr(path.string()), HasSubstr(what))));
  EXPECT_EQ(folder.files(), 3);
}

TEST(PartFile, SaysWhichLimitStoppedIt) {
  const Folder folder;
  const PartFile file(folder / "a.csv");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit short_files{10, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &short_files);
  EXPECT_THAT([&] { file.write("more than ten bytes"); }, ThrowsMessage<NumericalError>(HasSubstr("ulimit -f")));
  ::setrlimit(RLIMIT_FSIZE, &before);
}

}  // namespace
}  // namespace ritz::files
