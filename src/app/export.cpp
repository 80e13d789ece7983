#include "ritz/app/export.hpp"

#include <cerrno>
#include <fstream>
#include <string>

#include "ritz/algebra/write_matrix.hpp"
#include "ritz/files/part_file.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"
#include "ritz/parallel/redistribute.hpp"

namespace ritz::app {
namespace {

/// Numbers of the free degrees of freedom, `width` each, of this rank's even slice in the file's order: what `numbers`
/// appends for component c of owned vertex v.
template <class Numbers>
std::vector<std::int64_t> in_file_order(const mesh::Mesh& mesh, const mesh::Dofs& dofs, int width, Numbers numbers) {
  std::vector<std::int64_t> keys, values;
  for (int v = 0; v < mesh.owned; ++v)
    for (int c = 0; c < mesh::components; ++c) {
      if (dofs.fixed(v, c)) continue;
      keys.push_back(mesh::components * mesh.file_positions[static_cast<std::size_t>(v)] + c);
      numbers(v, c, values);
    }
  return parallel::sorted_by_key(mesh.comm, keys, values, width, mesh::components * mesh.vertices_total);
}

/// row,vertex,component of each row of the matrices.
void write_rows(const PendingFile& file, const stages::Problem& problem) {
  const auto& mesh = problem.mesh;
  const auto mine = in_file_order(mesh, problem.dofs, 2, [&](int v, int c, std::vector<std::int64_t>& values) {
    values.insert(values.end(), {mesh.ids[static_cast<std::size_t>(v)], c});
  });
  std::ofstream out;
  std::int64_t row = 0;
  parallel::on_root(mesh.comm, [&] {
    out.open(file.part(), std::ios::binary);
    out << "row,vertex,component\n";
  });
  parallel::in_rank_order<std::int64_t>(mesh.comm, mine, [&](auto piece) {
    for (std::size_t i = 0; i < piece.size(); i += 2)
      out << ++row << ',' << piece[i] << ',' << "xyz"[piece[i + 1]] << '\n';
  });
  parallel::on_root(mesh.comm, [&] {
    errno = 0;
    out.close();
    if (!out) files::fail_to_write(file.part().string(), errno);
  });
}

}  // namespace

std::vector<std::filesystem::path> exported_files(const config::Config& config) {
  if (config.exported == config::Export::nothing) return {};
  const std::string ending = config.exported == config::Export::matrixmarket ? ".mtx" : ".bin";
  std::vector<std::filesystem::path> files;
  for (const std::string name : {"_K", "_M", "_modes"})
    files.push_back(config.output.parent_path() / (config.output.stem().string() + name + ending));
  files.push_back(config.output.parent_path() / (config.output.stem().string() + "_rows.csv"));
  return files;
}

std::vector<PendingFile> export_matrices(const config::Config& config, const stages::Problem& problem,
                                         const algebra::Tall& modes) {
  const auto order = in_file_order(problem.mesh, problem.dofs, 1, [&](int v, int c, std::vector<std::int64_t>& values) {
    values.push_back(problem.dofs.number(v, c));
  });
  const auto format = config.exported == config::Export::matrixmarket ? algebra::MatrixFormat::matrixmarket
                                                                      : algebra::MatrixFormat::petsc_binary;
  std::vector<PendingFile> files;
  for (const auto& path : exported_files(config)) files.emplace_back(problem.mesh.comm, path);
  algebra::write_matrix(files[0].part(), problem.matrices.stiffness, order, format);
  algebra::write_matrix(files[1].part(), problem.matrices.mass, order, format);
  algebra::write_columns(files[2].part(), problem.mesh.comm, modes, order, format);
  write_rows(files[3], problem);
  for (const auto& file : files) file.finish();
  return files;
}

}  // namespace ritz::app
