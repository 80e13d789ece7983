// Tall matrices of three kinds, so that the compiler tells matrices with different rows apart.
#pragma once
#include <utility>

#include "ritz/algebra/multivector.hpp"

namespace ritz::mesh {

inline constexpr int components = 3;  ///< displacement components of a vertex

struct Free {};      ///< the free degrees of freedom of this rank
struct Vertices {};  ///< the vertices that this rank owns, 3 rows each, fixed components included
struct Locals {};    ///< all vertices that this rank holds, 3 rows each: its own, then ghosts

/// A matrix over rows of one kind, one column for each vector. The result of an expression has no kind and can be
/// assigned to any; passing a matrix of one kind where another is expected does not compile.
template <class Kind>
struct Rows : algebra::Tall {
  using algebra::Tall::Tall;
  using algebra::Tall::operator=;
  Rows() = default;
  Rows(algebra::Tall&& matrix) : algebra::Tall(std::move(matrix)) {}
  template <class Other>
  Rows(const Rows<Other>&) = delete;
  template <class Other>
  Rows& operator=(const Rows<Other>&) = delete;
};

/// An argument that is only read: such a matrix, or some of its columns.
template <class Kind>
struct RowsRef : algebra::ConstTallRef {
  template <class Expression>
  RowsRef(const Eigen::DenseBase<Expression>& expression) : algebra::ConstTallRef(expression) {}
  RowsRef(const Rows<Kind>& rows) : algebra::ConstTallRef(static_cast<const algebra::Tall&>(rows)) {}
  template <class Other>
  RowsRef(const Rows<Other>&) = delete;
  template <class Other>
  RowsRef(const RowsRef<Other>&) = delete;
};

using FreeRows = Rows<Free>;
using VertexRows = Rows<Vertices>;
using LocalRows = Rows<Locals>;
using FreeRef = const RowsRef<Free>&;
using VertexRef = const RowsRef<Vertices>&;
using LocalRef = const RowsRef<Locals>&;

/// The rows of vertex v in a matrix or vector with three rows for each vertex.
template <class Vertexwise>
auto at_vertex(Vertexwise&& rows, Eigen::Index v) {
  return rows.template middleRows<components>(components * v);
}

/// The 3 x 3 block of the vertices a and b in the matrix of a cell.
template <class Matrix>
auto at_vertices(Matrix&& matrix, Eigen::Index a, Eigen::Index b) {
  return matrix.template block<components, components>(components * a, components * b);
}

}  // namespace ritz::mesh
