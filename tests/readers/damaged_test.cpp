// Damaged files: cut off anywhere, or with wrong bytes. Either an InputError or a mesh that is consistent.
#include <gtest/gtest.h>

#include <tuple>

#include "readers/fixture.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/random.hpp"

namespace ritz::readers::testing {
namespace {

void expect_error_or_mesh(const std::string& name, const std::string& bytes) {
  const TemporaryFile file(name, bytes);
  try {
    expect_consistent(read_file(file.path()));
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

TEST(DamagedFile, CutOffAnywhere) {
  for (const auto& file : good_files()) {
    SCOPED_TRACE(file.label);
    for (std::size_t length = 1; length < file.bytes.size(); length += 11) {
      expect_error_or_mesh(file.name, file.bytes.substr(0, length));
    }
  }
}

TEST(DamagedFile, CutOffInsideACellIsAnError) {
  for (const auto& [name, text, last] :
       {std::tuple{"a.msh", msh22_text(), "4000 50"}, std::tuple{"a.msh", msh41_text(), "6 7 30 4000"},
        std::tuple{"a.veg", veg_text(), "2 2 3"}, std::tuple{"a.inp", inp_text(), "6, 7, 30,"}}) {
    const auto end = text.find(last) + std::string(last).size();
    EXPECT_NE(error_of(name, text.substr(0, end)).find(name), std::string::npos);
  }
}

TEST(DamagedFile, WithWrongBytes) {
  constexpr std::uint64_t stream = 20;
  std::uint64_t counter = 0;
  const auto random = [&](std::size_t below) { return split_mix(split_mix(stream) ^ counter++) % below; };
  for (const auto& file : good_files()) {
    SCOPED_TRACE(file.label);
    for (int trial = 0; trial < 150; ++trial) {
      auto bytes = file.bytes;
      for (auto changes = 1 + random(3); changes > 0; --changes) {
        const auto at = random(bytes.size());
        // Half of the time a character from elsewhere in the file, so that numbers stay numbers.
        bytes[at] = random(2) == 0 ? bytes[random(bytes.size())] : static_cast<char>(random(256));
      }
      expect_error_or_mesh(file.name, bytes);
    }
  }
}

}  // namespace
}  // namespace ritz::readers::testing
