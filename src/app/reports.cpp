#include "ritz/app/reports.hpp"

#include <algorithm>

#include "ritz/base/error.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {
namespace {

namespace fs = std::filesystem;

/// What a report must leave alone.
std::vector<fs::path> others(const config::Config& config) {
  std::vector<fs::path> files = config.source.vertex_lists;
  files.insert(files.end(), config.option_files.begin(), config.option_files.end());
  if (const auto* mesh = std::get_if<fs::path>(&config.source.mesh)) files.push_back(*mesh);
  if (config.accuracy) files.push_back(config.accuracy->scene);
  for (const auto* file : {&config.snapshots, &config.reuse, &config.full.restart, &config.full.timing})
    if (*file) files.push_back(**file);
  files.push_back(config.full.scene);
  files.push_back(config.output);
  return files;
}

bool same(const fs::path& a, const fs::path& b) {
  std::error_code none;
  return fs::equivalent(a, b, none) || fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
}

void refuse(const std::string& given, const fs::path& path, const std::vector<fs::path>& taken) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code none;
  if (!fs::is_directory(folder, none)) throw InputError(given + ": there is no folder " + folder.string());
  const auto status = fs::symlink_status(path, none);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw InputError(given + " is a link, a folder or a device: choose another name");
  if (std::ranges::any_of(taken, [&](const fs::path& file) { return !file.empty() && same(file, path); }))
    throw InputError(given + " is a file that the run reads, or writes besides: choose another name");
}

}  // namespace

void refuse_reports(MPI_Comm comm, const config::Config& config) {
  parallel::on_root(comm, [&] {
    auto taken = others(config);
    for (const auto& [name, file] : config.reports) {
      refuse("option -" + name + " :" + file, file, taken);
      taken.push_back(file);
    }
  });
}

}  // namespace ritz::app
