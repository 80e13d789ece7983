#include "ritz/stages/block_rows.hpp"

#include "ritz/algebra/check.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::stages {
namespace {

void append(std::vector<PetscInt>& to, const std::vector<PetscInt>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// What the rows of a vertex have in common: their columns, and where each neighbour's begin.
algebra::Rows columns_of(const mesh::Mesh& mesh, const mesh::Dofs& dofs, int row, BlockPattern& pattern) {
  algebra::Rows shared;
  for (auto p = pattern.graph.starts[static_cast<std::size_t>(row)];
       p < pattern.graph.starts[static_cast<std::size_t>(row) + 1]; ++p) {
    const int column = pattern.graph.columns[p];
    auto& columns = part(shared, mesh, column).columns;
    pattern.offsets.push_back(static_cast<PetscInt>(columns.size()));
    const mesh::Index origin = column < mesh.owned ? dofs.first : 0;
    for (int j = 0; j < mesh::components; ++j)
      if (!dofs.fixed(column, j)) columns.push_back(static_cast<PetscInt>(dofs.number(column, j) - origin));
  }
  return shared;
}

}  // namespace

algebra::Csr& part(algebra::Rows& rows, const mesh::Mesh& mesh, int column) {
  return column < mesh.owned ? rows.own : rows.other;
}

BlockRows empty_rows(const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  BlockRows blocks;
  auto& [pattern, rows] = blocks;
  pattern.graph = vertex_graph(mesh);
  const auto entries = parallel::max(mesh.comm, 9 * static_cast<std::int64_t>(pattern.graph.columns.size()));
  algebra::refuse_beyond_index("a rank holds " + std::to_string(entries) + " entries of K (more ranks hold fewer each)",
                               entries);
  pattern.offsets.reserve(pattern.graph.columns.size());
  rows.own.columns.reserve(9 * pattern.graph.columns.size());
  for (int row = 0; row < mesh.owned; ++row) {
    const algebra::Rows shared = columns_of(mesh, dofs, row, pattern);
    for (int i = 0; i < mesh::components; ++i) {
      if (dofs.fixed(row, i)) continue;
      append(rows.own.columns, shared.own.columns);
      append(rows.other.columns, shared.other.columns);
      for (algebra::Csr* part : {&rows.own, &rows.other})
        part->starts.push_back(static_cast<PetscInt>(part->columns.size()));
    }
  }
  for (algebra::Csr* part : {&rows.own, &rows.other}) part->values.assign(part->columns.size(), 0);
  return blocks;
}

void add_block(algebra::Rows& rows, const BlockPattern& pattern, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
               std::size_t place, int row, int column, const Eigen::Matrix3d& block) {
  algebra::Csr& to = part(rows, mesh, column);
  for (int i = 0; i < mesh::components; ++i) {
    if (dofs.fixed(row, i)) continue;
    const auto local = static_cast<std::size_t>(dofs.number(row, i) - dofs.first);
    auto at = static_cast<std::size_t>(to.starts[local] + pattern.offsets[place]);
    for (int j = 0; j < mesh::components; ++j)
      if (!dofs.fixed(column, j)) to.values[at++] += block(i, j);
  }
}

}  // namespace ritz::stages
