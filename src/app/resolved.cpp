#include "ritz/app/resolved.hpp"

#include <algorithm>

#include "ritz/app/checksums.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::app {

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
