#include "ritz/app/summary.hpp"

#include "ritz/app/resources.hpp"
#include "ritz/app/warnings.hpp"
#include "ritz/files/summary.hpp"
#include "ritz/format/summaries.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::app {

using files::Json;

files::Json::Object summary_head(MPI_Comm comm, const char* program, const config::Config& config,
                                 const Progress& progress) {
  const Memory memory = peak_memory(comm);
  return files::summary_head({.program = program,
                              .ranks = parallel::size(comm),
                              .output = config.output.string(),
                              .stages = format::summary(progress.seconds()),
                              .largest_rank = memory.largest_rank,
                              .all_ranks = memory.all_ranks,
                              .warnings = progress.warnings()});
}

files::Json problem_summary(const stages::Problem& problem) {
  const auto& [mesh, dofs, materials, matrices] = problem;
  const auto [size, mass] = extent(mesh, materials);
  return Json::Object{{"vertices", mesh.vertices_total}, {"cells", mesh.cells_total},
                      {"named_sets", mesh.sets.size()},  {"dropped_vertices", mesh.dropped_vertices},
                      {"pieces", mesh.pieces},           {"degrees_of_freedom", dofs.total},
                      {"size", files::json_list(size)},  {"mass", mass}};
}

std::optional<PendingFile> written_summary(MPI_Comm comm, const config::Config& config,
                                           const std::function<files::Json::Object()>& members) {
  if (!config.summary) return std::nullopt;
  const std::string text = files::json_text(members());
  PendingFile file(comm, *config.summary);
  file.write(text);
  file.finish();
  return file;
}

}  // namespace ritz::app
