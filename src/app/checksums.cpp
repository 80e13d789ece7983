#include "ritz/app/checksums.hpp"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "ritz/base/error.hpp"
#include "ritz/base/random.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {
namespace {

std::string hexadecimal(std::uint64_t x) { return formatted("%016llx", static_cast<unsigned long long>(x)); }

std::uint64_t hash_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string() + " cannot be read");
  std::uint64_t h = 0;
  std::vector<char> bytes(1 << 20);
  while (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())), in.gcount() > 0) {
    std::fill(bytes.begin() + in.gcount(), bytes.end(), '\0');
    for (std::size_t i = 0; i < bytes.size(); i += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, &bytes[i], sizeof word);
      h = split_mix(h ^ word);
    }
  }
  return h;
}

}  // namespace

model::Checksums checksums(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const fem::Materials& materials) {
  std::uint64_t h = split_mix(mesh.checksum ^ split_mix(dofs.checksum));
  const auto add = [&](double x) { h = split_mix(h ^ std::bit_cast<std::uint64_t>(x)); };
  for (const auto& [law, density] : materials) {
    if (const std::string_view name = fem::name(law); name != fem::default_law)  // which earlier models did not name
      for (const char c : name) add(c);
    for (const auto& [parameter, value] : fem::parameters(law)) add(value);
    add(density);
  }
  return {hexadecimal(mesh.checksum), hexadecimal(h)};
}

std::string file_checksum(MPI_Comm comm, const std::filesystem::path& file) {
  std::string text;
  parallel::on_root(comm, [&] { text = hexadecimal(hash_of(file)); });
  parallel::broadcast(comm, text);
  return text;
}

}  // namespace ritz::app
