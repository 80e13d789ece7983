// Vectors and matrices of elements. They are of a fixed size, or of a size with a fixed bound: none is on the heap.
#pragma once
#include <Eigen/Core>
#include <array>

#include "ritz/fem/cell.hpp"

namespace ritz::fem {

template <int n>
using Vector = Eigen::Matrix<double, n, 1>;

template <int m, int n>
using Matrix = Eigen::Matrix<double, m, n>;

/// At most m x n.
template <int m, int n>
using UpTo = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, m, n>;

/// Reference coordinates in an element of dimension d.
template <int d>
using Point = std::array<double, d>;

/// Three numbers for each vertex of a cell, such as its coordinates or displacements, 3 x vertices, m.
using CellVectors = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, max_cell_vertices>;
/// The same for a face.
using FaceVectors = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, max_face_vertices>;

/// A matrix of a cell with three rows and columns for each vertex: row 3a + i is component i of vertex a.
using CellMatrix = UpTo<3 * max_cell_vertices, 3 * max_cell_vertices>;
/// A matrix of a cell with one row and column for each vertex.
using VertexMatrix = UpTo<max_cell_vertices, max_cell_vertices>;

/// The vertices minus the first one: cells far from the origin then lose no digits.
template <class Vectors>
Vectors relative(const Vectors& x) {
  return x.colwise() - x.col(0);
}

}  // namespace ritz::fem
