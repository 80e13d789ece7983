#include "ritz/stages/assemble.hpp"

#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/mass.hpp"
#include "ritz/fem/stiffness.hpp"
#include "ritz/petsc/csr.hpp"
#include "ritz/stages/vertex_graph.hpp"

namespace ritz::stages {
namespace {

/// 3 x 3 blocks of K and scalars of M_s on the vertex graph, rows of owned vertices.
struct Blocks {
  VertexGraph graph;
  std::vector<Eigen::Matrix3d> stiffness;
  std::vector<double> mass;
};

template <class E>
void add_cell(Blocks& blocks, const mesh::Mesh& mesh, int cell, const fem::StVK& material) {
  const auto vertices = mesh.cells.of(cell);
  fem::Coordinates<E> x;
  for (int a = 0; a < E::vertices; ++a) x.col(a) = mesh.points.col(vertices[static_cast<std::size_t>(a)]);
  const auto K = fem::stiffness<E>(x, material);
  const auto M = fem::mass<E>(x, material.density);
  for (int a = 0; a < E::vertices; ++a) {
    const int row = vertices[static_cast<std::size_t>(a)];
    if (row >= mesh.owned) continue;
    for (int b = 0; b < E::vertices; ++b) {
      const auto place = blocks.graph.place(mesh.global, row, vertices[static_cast<std::size_t>(b)]);
      blocks.stiffness[place] += K.template block<3, 3>(3 * a, 3 * b);
      blocks.mass[place] += M(a, b);
    }
  }
}

Blocks add_cells(const mesh::Mesh& mesh, const std::vector<fem::StVK>& materials) {
  Blocks blocks{vertex_graph(mesh), {}, {}};
  blocks.stiffness.assign(blocks.graph.columns.size(), Eigen::Matrix3d::Zero());
  blocks.mass.assign(blocks.graph.columns.size(), 0);
  for (const int c : file_order(mesh.cells)) {
    const auto i = static_cast<std::size_t>(c);
    const auto& material = materials[static_cast<std::size_t>(mesh.cells.regions[i])];
    fem::visit(mesh.cells.types[i], [&]<class E>(E) { add_cell<E>(blocks, mesh, c, material); });
  }
  return blocks;
}

/// Goes through the free entries of each owned row in order: take(place, component of the row, of the column, column).
template <class Take, class End>
void each_free_entry(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const VertexGraph& graph, Take take, End end_row) {
  for (int row = 0; row < mesh.owned; ++row)
    for (int i = 0; i < mesh::components; ++i) {
      if (dofs.fixed(row, i)) continue;
      for (auto p = graph.starts[static_cast<std::size_t>(row)]; p < graph.starts[static_cast<std::size_t>(row) + 1];
           ++p)
        for (int j = 0; j < mesh::components; ++j)
          if (!dofs.fixed(graph.columns[p], j)) take(p, i, j, dofs.number(graph.columns[p], j));
      end_row();
    }
}

petsc::Matrix stiffness_matrix(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Blocks& blocks) {
  petsc::Csr csr;
  csr.columns.reserve(9 * blocks.stiffness.size());
  csr.values.reserve(9 * blocks.stiffness.size());
  each_free_entry(
      mesh, dofs, blocks.graph,
      [&](std::size_t p, int i, int j, mesh::Index column) {
        csr.columns.push_back(static_cast<PetscInt>(column));
        csr.values.push_back(blocks.stiffness[p](i, j));
      },
      [&] { csr.starts.push_back(static_cast<PetscInt>(csr.columns.size())); });
  return petsc::symmetric_matrix(mesh.comm, csr, dofs.block, petsc::Definite::semi);
}

petsc::Matrix mass_matrix(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Blocks& blocks) {
  petsc::Csr csr;
  csr.columns.reserve(3 * blocks.mass.size());
  csr.values.reserve(3 * blocks.mass.size());
  each_free_entry(
      mesh, dofs, blocks.graph,
      [&](std::size_t p, int i, int j, mesh::Index column) {
        if (i != j) return;
        csr.columns.push_back(static_cast<PetscInt>(column));
        csr.values.push_back(blocks.mass[p]);
      },
      [&] { csr.starts.push_back(static_cast<PetscInt>(csr.columns.size())); });
  return petsc::symmetric_matrix(mesh.comm, csr, dofs.block, petsc::Definite::positive);
}

petsc::Matrix scalar_mass_matrix(const mesh::Mesh& mesh, Blocks& blocks) {
  petsc::Csr csr;
  csr.values = std::move(blocks.mass);
  for (const int v : blocks.graph.columns)
    csr.columns.push_back(static_cast<PetscInt>(mesh.global[static_cast<std::size_t>(v)]));
  csr.starts.assign(blocks.graph.starts.begin(), blocks.graph.starts.end());
  return petsc::symmetric_matrix(mesh.comm, csr, 1, petsc::Definite::positive);
}

}  // namespace

Full assemble(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const std::vector<fem::StVK>& materials) {
  Blocks blocks = add_cells(mesh, materials);
  Full full;
  full.materials = materials;
  full.stiffness = stiffness_matrix(mesh, dofs, blocks);
  blocks.stiffness = {};
  full.mass = mass_matrix(mesh, dofs, blocks);
  full.scalar_mass = scalar_mass_matrix(mesh, blocks);
  return full;
}

}  // namespace ritz::stages
