// Meshes on all ranks for tests, and what every distributed mesh must satisfy.
#pragma once
#include <string>

#include "ritz/mesh/mesh.hpp"
#include "ritz/mesh/part.hpp"
#include "ritz/mesh/read.hpp"

namespace ritz::mesh::testing {

inline const MPI_Comm world = MPI_COMM_WORLD;

/// A generated box on the ranks of `comm`.
Mesh box_mesh(const std::string& text, MPI_Comm comm = world);

/// The same box as a mesh file would state it.
FileMesh file_of_box(const std::string& text);

/// Tetrahedra in a file mesh with one region and no sets.
FileMesh tetrahedra(const std::vector<std::array<double, 3>>& points, const std::vector<std::array<Index, 4>>& cells);

/// Cuts a file mesh, which every rank holds, into parts.
Mesh distributed(const FileMesh& mesh, Partitioner partitioner = Partitioner::metis);

/// Each vertex and cell is owned once; owned vertices are contiguous and ascend; ghosts carry their owners' numbers; a
/// rank's cells are its own and exactly those others that touch its vertices. *Collective*.
void expect_sound(const Mesh& mesh);

/// (position, value) pairs of all ranks agree where they share a position. *Collective*.
void expect_agreement(const std::vector<Index>& positions, const std::vector<Index>& values);

}  // namespace ritz::mesh::testing
