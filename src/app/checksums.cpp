#include "ritz/app/checksums.hpp"

#include <bit>
#include <cstdio>

#include "ritz/base/random.hpp"

namespace ritz::app {
namespace {

std::string hexadecimal(std::uint64_t x) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(x));
  return text;
}

}  // namespace

Checksums checksums(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const std::vector<fem::StVK>& materials) {
  std::uint64_t h = split_mix(mesh.checksum ^ split_mix(dofs.checksum));
  for (const auto& m : materials)
    for (const double x : {m.young, m.poisson, m.density}) h = split_mix(h ^ std::bit_cast<std::uint64_t>(x));
  return {hexadecimal(mesh.checksum), hexadecimal(h)};
}

}  // namespace ritz::app
