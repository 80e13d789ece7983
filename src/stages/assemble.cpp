#include "ritz/stages/assemble.hpp"

#include <utility>

#include "ritz/fem/dispatch.hpp"
#include "ritz/fem/mass.hpp"
#include "ritz/fem/stiffness.hpp"
#include "ritz/petsc/csr.hpp"
#include "ritz/stages/vertex_graph.hpp"

namespace ritz::stages {
namespace {

/// K's rows, filled in place, and one number of M_s for each entry of the vertex graph.
struct Sums {
  VertexGraph graph;
  std::vector<PetscInt> offsets;  ///< of a graph entry: how many columns stand before it in each of its vertex's rows
  petsc::Csr stiffness;
  std::vector<double> mass;
};

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

Sums empty_sums(const mesh::Mesh& mesh, const mesh::Dofs& dofs) {
  Sums sums;
  sums.graph = vertex_graph(mesh);
  const auto entries = sums.graph.columns.size();
  sums.mass.assign(entries, 0);
  sums.offsets.resize(entries);
  sums.stiffness.columns.reserve(9 * entries);
  for (std::size_t row = 0; row + 1 < sums.graph.starts.size(); ++row) {
    PetscInt before = 0;
    for (auto p = sums.graph.starts[row]; p < sums.graph.starts[row + 1]; ++p) {
      sums.offsets[p] = before;
      for (int j = 0; j < mesh::components; ++j) before += !dofs.fixed(sums.graph.columns[p], j);
    }
  }
  each_free_entry(
      mesh, dofs, sums.graph,
      [&](std::size_t, int, int, mesh::Index column) {
        sums.stiffness.columns.push_back(static_cast<PetscInt>(column));
      },
      [&] { sums.stiffness.starts.push_back(static_cast<PetscInt>(sums.stiffness.columns.size())); });
  sums.stiffness.values.assign(sums.stiffness.columns.size(), 0);
  return sums;
}

/// Adds the block of two vertices to the rows of the first.
void add_block(Sums& sums, const mesh::Dofs& dofs, std::size_t place, int row, int column, const Eigen::Matrix3d& K) {
  for (int i = 0; i < mesh::components; ++i) {
    if (dofs.fixed(row, i)) continue;
    const auto local = static_cast<std::size_t>(dofs.number(row, i) - dofs.first);
    auto at = static_cast<std::size_t>(sums.stiffness.starts[local] + sums.offsets[place]);
    for (int j = 0; j < mesh::components; ++j)
      if (!dofs.fixed(column, j)) sums.stiffness.values[at++] += K(i, j);
  }
}

template <class E>
void add_cell(Sums& sums, const mesh::Mesh& mesh, const mesh::Dofs& dofs, int cell, const fem::StVK& material) {
  const auto vertices = mesh.cells.of(cell);
  fem::Coordinates<E> x;
  for (int a = 0; a < E::vertices; ++a) x.col(a) = mesh.points.col(vertices[static_cast<std::size_t>(a)]);
  const auto K = fem::stiffness<E>(x, material);
  const auto M = fem::mass<E>(x, material.density);
  for (int a = 0; a < E::vertices; ++a) {
    const int row = vertices[static_cast<std::size_t>(a)];
    if (row >= mesh.owned) continue;
    for (int b = 0; b < E::vertices; ++b) {
      const int column = vertices[static_cast<std::size_t>(b)];
      const auto place = sums.graph.place(mesh.global, row, column);
      add_block(sums, dofs, place, row, column, K.template block<3, 3>(3 * a, 3 * b));
      sums.mass[place] += M(a, b);
    }
  }
}

void add_cells(Sums& sums, const mesh::Mesh& mesh, const mesh::Dofs& dofs, const std::vector<fem::StVK>& materials) {
  for (const int c : file_order(mesh.cells)) {
    const auto i = static_cast<std::size_t>(c);
    const auto& material = materials[static_cast<std::size_t>(mesh.cells.regions[i])];
    fem::visit(mesh.cells.types[i], [&]<class E>(E) { add_cell<E>(sums, mesh, dofs, c, material); });
  }
}

petsc::Matrix mass_matrix(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const Sums& sums) {
  petsc::Csr csr;
  csr.columns.reserve(3 * sums.mass.size());
  csr.values.reserve(3 * sums.mass.size());
  each_free_entry(
      mesh, dofs, sums.graph,
      [&](std::size_t p, int i, int j, mesh::Index column) {
        if (i != j) return;
        csr.columns.push_back(static_cast<PetscInt>(column));
        csr.values.push_back(sums.mass[p]);
      },
      [&] { csr.starts.push_back(static_cast<PetscInt>(csr.columns.size())); });
  return petsc::symmetric_matrix(mesh.comm, std::move(csr), dofs.block, petsc::Definite::positive);
}

petsc::Matrix scalar_mass_matrix(const mesh::Mesh& mesh, Sums& sums) {
  petsc::Csr csr;
  csr.values = std::move(sums.mass);
  for (const int v : sums.graph.columns)
    csr.columns.push_back(static_cast<PetscInt>(mesh.global[static_cast<std::size_t>(v)]));
  csr.starts.assign(sums.graph.starts.begin(), sums.graph.starts.end());
  return petsc::symmetric_matrix(mesh.comm, std::move(csr), 1, petsc::Definite::positive);
}

}  // namespace

Full assemble(const mesh::Mesh& mesh, const mesh::Dofs& dofs, const std::vector<fem::StVK>& materials) {
  Sums sums = empty_sums(mesh, dofs);
  add_cells(sums, mesh, dofs, materials);
  Full full;
  full.materials = materials;
  full.stiffness = petsc::symmetric_matrix(mesh.comm, std::move(sums.stiffness), dofs.block, petsc::Definite::semi);
  full.mass = mass_matrix(mesh, dofs, sums);
  full.scalar_mass = scalar_mass_matrix(mesh, sums);
  return full;
}

}  // namespace ritz::stages
