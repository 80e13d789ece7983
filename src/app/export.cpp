#include "ritz/app/export.hpp"

#include <string>

#include "ritz/algebra/write_matrix.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/redistribute.hpp"

namespace ritz::app {
namespace {

/// The global numbers of this rank's even slice of the free degrees of freedom in the file's order.
std::vector<std::int64_t> numbers_in_file_order(const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  std::vector<std::int64_t> keys, numbers;
  for (int v = 0; v < mesh.owned; ++v)
    for (int c = 0; c < mesh::components; ++c) {
      if (dofs.fixed(v, c)) continue;
      keys.push_back(mesh::components * mesh.file_positions[static_cast<std::size_t>(v)] + c);
      numbers.push_back(dofs.number(v, c));
    }
  return parallel::sorted_by_key(mesh.comm, keys, numbers, 1, mesh::components * mesh.vertices_total);
}

}  // namespace

std::vector<std::filesystem::path> exported_files(const config::Config& config) {
  if (config.exported == config::Export::nothing) return {};
  const std::string ending = config.exported == config::Export::matrixmarket ? ".mtx" : ".bin";
  std::vector<std::filesystem::path> files;
  for (const std::string name : {"_K", "_M", "_modes"})
    files.push_back(config.output.parent_path() / (config.output.stem().string() + name + ending));
  return files;
}

std::vector<PendingFile> export_matrices(const config::Config& config, const stages::Problem& problem,
                                         const algebra::Tall& modes) {
  const auto order = numbers_in_file_order(problem.mesh, problem.dofs);
  const auto format = config.exported == config::Export::matrixmarket ? algebra::MatrixFormat::matrixmarket
                                                                      : algebra::MatrixFormat::petsc_binary;
  std::vector<PendingFile> files;
  for (const auto& path : exported_files(config)) files.emplace_back(problem.mesh.comm, path);
  algebra::write_matrix(files[0].part(), problem.matrices.stiffness, order, format);
  algebra::write_matrix(files[1].part(), problem.matrices.mass, order, format);
  algebra::write_columns(files[2].part(), problem.mesh.comm, modes, order, format);
  for (const auto& file : files) file.finish();
  return files;
}

}  // namespace ritz::app
