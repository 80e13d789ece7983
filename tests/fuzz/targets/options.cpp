// An options file (with the ending that RITZ_FUZZ_OPTIONS names) on a generated mesh, read as ritz-reduce reads it.
#include "config/configured.hpp"
#include "fuzz/parallel_setting.hpp"
#include "fuzz/target.hpp"

namespace ritz::fuzz {

void read_input(Bytes input) {
  static const Setting setting;
  config::testing::configured(
      {"-mesh", "box:1,1,1/1,1,1/tet4", "-options_file", as_file(input, "some" RITZ_FUZZ_OPTIONS).string()});
}

}  // namespace ritz::fuzz
