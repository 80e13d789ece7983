#include "ritz/app/provenance.hpp"

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

Options resolved(const config::Config& config, const mesh::Mesh& mesh, stages::Strategy strategy) {
  auto options = config.resolved;
  for (auto& [name, value] : options) {
    if (name == "solver") value = strategy == stages::Strategy::direct ? "direct" : "iterative";
    if (name == "snapshots" || name == "accuracy_scene") value += " (checksum " + file_checksum(mesh.comm, value) + ")";
  }
  if (config.file_supports == mesh::FileSupports::used) {
    const bool held = parallel::max(mesh.comm, static_cast<std::int32_t>(!mesh.supports.empty())) > 0;
    options.emplace_back("fix", held ? "the mesh file's own" : "none");
  }
  return options;
}

std::string value_of(const Options& options, const std::string& name) {
  const auto found = std::ranges::find(options, name, &Options::value_type::first);
  return found == options.end() ? "" : found->second;
}

}  // namespace ritz::app
