#include "ritz/files/claim.hpp"

#include <gmock/gmock.h>

#include "files/folder.hpp"
#include "ritz/base/error.hpp"

namespace ritz::files {
namespace {

using test::Folder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

Named named(const std::filesystem::path& path) { return {"option -x " + path.filename().string(), path}; }

TEST(Claim, HoldsNamesUntilItEnds) {
  const Folder folder;
  {
    const Claim first({.outputs = {named(folder / "a.h5"), named(folder / "a.csv")}});
    EXPECT_EQ(folder.files(), 0) << "nothing stands there that a kill could leave";
    for (const auto* taken : {"a.h5", "a.csv", "./a.csv"})
      EXPECT_THAT(
          [&] {
            Claim({.outputs = {named(folder / "b.h5"), named(folder / taken)}});
          },
          ThrowsMessage<InputError>(HasSubstr("another run is writing")));
    EXPECT_NO_THROW(Claim({.outputs = {named(folder / "b.h5")}})) << "which the claims that failed let go";
  }
  EXPECT_NO_THROW(Claim({.outputs = {named(folder / "a.h5")}}));
}

TEST(Claim, SeesWhatAnotherHasWrittenMeanwhile) {
  const Folder folder;
  test::save(folder / "old.h5", "1");
  const Claim claim({.outputs = {named(folder / "new.h5"), named(folder / "old.h5")}});
  EXPECT_NO_THROW(claim.verify());
  EXPECT_EQ(claim.replaced(), "replaced " + (folder / "old.h5").string());
  EXPECT_EQ(Claim({.outputs = {named(folder / "newer.h5")}}).replaced(), "");
  test::save(folder / "other.h5", "1");
  EXPECT_NO_THROW(claim.verify()) << "of other names nothing is said";
  std::filesystem::rename(folder / "other.h5", folder / "old.h5");
  EXPECT_THAT([&] { claim.verify(); }, ThrowsMessage<InputError>(HasSubstr("-x old.h5: another run")));
  std::filesystem::remove(folder / "old.h5");
  EXPECT_NO_THROW(claim.verify()) << "where nothing stands, nothing is lost";
  test::save(folder / "new.h5", "1");
  EXPECT_THAT([&] { claim.verify(); }, ThrowsMessage<InputError>(HasSubstr("-x new.h5: another run")));
}

TEST(Claim, RefusesToWriteOverAnInput) {
  const Folder folder;
  test::save(folder / "a.inp", "mesh");
  std::filesystem::create_hard_link(folder / "a.inp", folder / "hard.inp");
  std::filesystem::create_symlink("hard.inp", folder / "soft.inp");
  for (const auto* input : {"a.inp", "./a.inp", "hard.inp", "soft.inp"}) {
    const Plan plan{.outputs = {named(folder / "b.h5"), named(folder / "a.inp")}, .inputs = {named(folder / input)}};
    EXPECT_THAT([&] { Claim{plan}; }, ThrowsMessage<InputError>(HasSubstr("-x a.inp would overwrite an input")))
        << input;
  }
  const Claim claim({.outputs = {named(folder / "a.inp")}});
  EXPECT_THROW(claim.refuse({named(folder / "hard.inp")}), InputError);
  EXPECT_NO_THROW(claim.refuse({named(folder / "none.inp")}));
}

TEST(Claim, LetsOnlyTheFirstOutputTakeThePlaceOfWhatItGoesOnFrom) {
  const Folder folder;
  test::save(folder / "a.h5", "earlier");
  const auto a = named(folder / "a.h5"), b = named(folder / "b.h5");
  EXPECT_NO_THROW(Claim({.outputs = {a, b}, .replaceable = {a}}));
  EXPECT_THROW(Claim({.outputs = {b, a}, .replaceable = {a}}), InputError);
}

TEST(Claim, RefusesOneNameTwice) {
  const Folder folder;
  test::save(folder / "a.h5", "");
  std::filesystem::create_hard_link(folder / "a.h5", folder / "b.h5");
  for (const auto* other : {"a.h5", "./a.h5", "b.h5"})
    EXPECT_THAT(
        [&] {
          Claim({.outputs = {named(folder / "a.h5"), named(folder / other)}});
        },
        ThrowsMessage<InputError>(HasSubstr("writes besides")));
}

TEST(Claim, RefusesReportsInThePlaceOfOtherFilesAndLetsThemChange) {
  const Folder folder;
  test::save(folder / "a.inp", "mesh");
  const auto model = named(folder / "a.h5"), table = named(folder / "a.csv"), log = named(folder / "log");
  const auto mesh = named(folder / "a.inp");
  for (const auto& report : {model, table, mesh})
    EXPECT_THROW(Claim({.outputs = {model, table}, .inputs = {mesh}, .reports = {report}}), InputError);
  EXPECT_THROW(Claim({.outputs = {model}, .reports = {log, log}}), InputError);
  EXPECT_THROW(Claim({.outputs = {}, .links = {model}, .reports = {model}}), InputError);
  const Claim claim({.outputs = {model}, .reports = {log}});
  EXPECT_THAT([&] { Claim({.outputs = {table}, .reports = {log}}); },
              ThrowsMessage<InputError>(HasSubstr("another run is writing")));
  test::save(log.path, "by PETSc");
  EXPECT_NO_THROW(claim.verify());
}

TEST(Claim, LeavesLinksToWhatTheyLeadTo) {
  const Folder folder;
  test::save(folder / "a.h5", "");
  std::filesystem::create_symlink("a.h5", folder / "a.hdf");
  const auto output = named(folder / "a.h5"), link = named(folder / "a.hdf");
  EXPECT_NO_THROW(Claim({.outputs = {output}, .links = {link}}));
  EXPECT_THROW(Claim({.outputs = {output, link}, .links = {link}}), InputError);
  EXPECT_THROW(Claim({.outputs = {output}, .links = {link}, .inputs = {link}}), InputError);
}

TEST(Claim, RefusesPlacesThatTakeNoFile) {
  const Folder folder;
  std::filesystem::create_directory(folder / "folder");
  const std::pair<std::filesystem::path, std::string> bad[] = {{folder / "folder", "is a folder"},
                                                               {folder / "folder/", "is a folder"},
                                                               {folder / "none/a.h5", "there is no folder"},
                                                               {"/dev/full", "is a device"},
                                                               {"/proc/a.h5", "takes no files"},
                                                               {folder / std::string(300, 'a'), "name is too long"}};
  for (const auto& [path, what] : bad)
    EXPECT_THAT([&] { Claim({.outputs = {named(path)}}); }, ThrowsMessage<InputError>(HasSubstr(what))) << path;
  EXPECT_EQ(folder.files(), 1);
}

}  // namespace
}  // namespace ritz::files
