// The bytes of a model file.
#include "fuzz/models.hpp"
#include "fuzz/target.hpp"

namespace ritz::fuzz {

void read_input(Bytes input) {
  static const auto quiet = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  static_cast<void>(quiet);
  read_as_all_programs(format::ModelReader(std::as_bytes(input)));
}

}  // namespace ritz::fuzz
