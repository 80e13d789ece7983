#include "ritz/app/export.hpp"

#include <string>

#include "ritz/app/pending_file.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/redistribute.hpp"
#include "ritz/petsc/write_matrix.hpp"

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

void export_matrices(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                     const stages::Full& full, const petsc::Tall& modes) {
  const auto order = numbers_in_file_order(mesh, dofs);
  const auto format = config.exported == config::Export::matrixmarket ? petsc::MatrixFormat::matrixmarket
                                                                      : petsc::MatrixFormat::petsc_binary;
  const std::string ending = format == petsc::MatrixFormat::matrixmarket ? ".mtx" : ".bin";
  const auto file = [&](const std::string& name) {
    return PendingFile(mesh.comm, config.output.parent_path() / (config.output.stem().string() + "_" + name + ending));
  };
  PendingFile stiffness = file("K"), mass = file("M"), columns = file("modes");
  petsc::write_matrix(stiffness.part(), full.stiffness, order, format);
  petsc::write_matrix(mass.part(), full.mass, order, format);
  petsc::write_columns(columns.part(), mesh.comm, modes, order, format);
  for (auto* written : {&stiffness, &mass, &columns}) written->publish();
}

}  // namespace ritz::app
