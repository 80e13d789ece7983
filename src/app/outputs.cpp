#include "ritz/app/outputs.hpp"

#include <unistd.h>

#include "ritz/base/error.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> inputs(const config::Config& config) {
  std::vector<fs::path> files = config.source.vertex_lists;
  if (const auto* mesh = std::get_if<fs::path>(&config.source.mesh)) files.push_back(*mesh);
  if (config.accuracy) files.push_back(config.accuracy->scene);
  if (config.snapshots) files.push_back(*config.snapshots);
  files.push_back(config.full.scene);
  return files;
}

void refuse(const std::string& option, const fs::path& path, const std::vector<fs::path>& read) {
  const std::string given = "option -" + option + " " + path.string();
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (!fs::is_directory(folder)) throw InputError(given + ": there is no folder " + folder.string());
  if (fs::is_directory(path)) throw InputError(given + " is a folder; name a file in it");
  if (access(folder.c_str(), W_OK) != 0)
    throw InputError(given + ": the folder " + folder.string() + " cannot be written to");
  std::error_code none;
  for (const auto& input : read)
    if (fs::equivalent(input, path, none)) throw InputError(given + " would overwrite an input: choose another name");
}

void refuse_twice(const fs::path& timing, const fs::path& output) {
  const fs::path folder = output.parent_path(), xdmf = fs::path(output).replace_extension(".xdmf");
  for (const auto& other : {output, xdmf, folder / "probes.csv", folder / "energy.csv"})
    if (fs::absolute(timing).lexically_normal() == fs::absolute(other).lexically_normal())
      throw InputError("option -timing " + timing.string() +
                       " is a file that the run writes besides: choose another name");
}

}  // namespace

void refuse_outputs(MPI_Comm comm, const config::Config& config) {
  parallel::on_root(comm, [&] {
    const auto read = inputs(config);
    refuse("output", config.output, read);
    if (!config.full.timing) return;
    refuse("timing", *config.full.timing, read);
    refuse_twice(*config.full.timing, config.output);
  });
}

}  // namespace ritz::app
