// Links of a group: in the order they were made in, and refused where the file that keeps them is damaged. HDF5 1.10
// frees a table of links that it could fill in part only.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstring>

#include "format/temporary.hpp"
#include "ritz/base/error.hpp"
#include "ritz/format/stored_file.hpp"

namespace ritz::format {
namespace {

using test::Bytes;
using testing::HasSubstr;
using testing::ThrowsMessage;

enum class Headers { unchecked, checked };  ///< object headers of version 1, and those of version 2

/// A file with a group "links" of so many groups, "m00", "m01", ... from the last to the first.
Bytes file_of_links(int count, Headers headers) {
  const test::Folder folder;
  {
    const Properties access(H5Pcreate(H5P_FILE_ACCESS)), creation(H5Pcreate(H5P_GROUP_CREATE));
    if (headers == Headers::checked) H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
    H5Pset_link_creation_order(creation.get(), H5P_CRT_ORDER_TRACKED);
    const File file(H5Fcreate((folder / "links.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()));
    const Group group(H5Gcreate2(file.get(), "links", H5P_DEFAULT, creation.get(), H5P_DEFAULT));
    for (int i = count - 1; i >= 0; --i) {
      const auto name = "m" + std::to_string(i / 10) + std::to_string(i % 10);
      const Group member(H5Gcreate2(group.get(), name.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT));
    }
  }
  return test::load(folder / "links.h5");
}

std::vector<std::string> surveyed(const Bytes& bytes) {
  const StoredFile in(bytes, "links.h5", {"model", "ritz-reduce"});
  constexpr std::string_view root = "/links";
  std::vector<std::string> paths;
  for (const auto& object : survey(in, std::span(&root, 1))) paths.push_back(object.path);
  return paths;
}

/// Every place where `what` stands.
std::vector<std::size_t> places(const Bytes& bytes, std::string_view what) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::vector<std::size_t> found;
  for (auto at = text.find(what); at != std::string_view::npos; at = text.find(what, at + 1)) found.push_back(at);
  return found;
}

TEST(Links, AreInTheOrderTheyWereMadeIn) {
  for (const auto headers : {Headers::unchecked, Headers::checked})
    for (const int count : {1, 8, 9, 40}) {  // HDF5 keeps more than 8 in a heap
      const auto paths = surveyed(file_of_links(count, headers));
      ASSERT_EQ(paths.size(), static_cast<std::size_t>(count) + 1);
      EXPECT_EQ(paths.front(), "/links");
      EXPECT_EQ(paths.back(), "/links/m00");
      EXPECT_TRUE(std::ranges::is_sorted(paths.begin() + 1, paths.end(), std::greater()));
    }
}

/// The heap's header and blocks, and the trees of its links.
TEST(Links, InADamagedHeapAreRefused) {
  const auto intact = file_of_links(40, Headers::checked);
  mallopt(M_PERTURB, 0xa5);  // a table that is freed half filled then holds no zeros
  int tried = 0;
  for (const std::string_view kind : {"FRHP", "FHDB", "BTHD", "BTLF"})
    for (const auto at : places(intact, kind))
      for (const std::size_t inside : {4, 8, 13, 21, 40}) {
        auto damaged = intact;
        damaged[at + inside] ^= std::byte{0x5a};
        try {
          EXPECT_EQ(surveyed(damaged).size(), 41U) << kind << " + " << inside;  // what this does not need
        } catch (const InputError&) {
          ++tried;
        }
      }
  mallopt(M_PERTURB, 0);
  EXPECT_GT(tried, 10);
}

TEST(Links, InADamagedHeaderAreRefused) {
  const auto intact = file_of_links(3, Headers::unchecked);
  const auto at = places(intact, "m01");
  ASSERT_EQ(at.size(), 1U);
  // Before the name stand, from its front: version, flags, creation order (8 bytes), the name's length.
  struct Damage {
    std::size_t before;
    unsigned char value;
  };
  for (const auto [before, value] : {Damage{11, 9}, {10, 0xff}, {10, 0x0f}, {1, 0}, {1, 0xfe}}) {
    auto damaged = intact;
    damaged[at[0] - before] = static_cast<std::byte>(value);
    EXPECT_THAT([&] { surveyed(damaged); }, ThrowsMessage<InputError>(HasSubstr("damaged"))) << before;
  }
}

}  // namespace
}  // namespace ritz::format
