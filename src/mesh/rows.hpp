// Three kinds of tall matrices whose rows mean different things, so that one is not taken for another.
#pragma once
#include <utility>

#include "ritz/petsc/multivector.hpp"

namespace ritz::mesh {

struct Free {};      ///< the free degrees of freedom of this rank
struct Vertices {};  ///< the vertices that this rank owns, 3 rows each, fixed components included
struct Locals {};    ///< all vertices that this rank knows: its own, then ghosts

/// A matrix over rows of one kind, a column each vector. What is computed of it has no kind, and may become any; but a
/// matrix of one kind is not accepted where another is expected: that does not compile.
template <class Kind>
struct Rows : petsc::Tall {
  using petsc::Tall::Tall;
  using petsc::Tall::operator=;
  Rows() = default;
  Rows(petsc::Tall&& matrix) : petsc::Tall(std::move(matrix)) {}
  template <class Other>
  Rows(const Rows<Other>&) = delete;
  template <class Other>
  Rows& operator=(const Rows<Other>&) = delete;
};

/// The same to be read by a function: a matrix, or some of its columns.
template <class Kind>
struct RowsRef : petsc::ConstTallRef {
  template <class Expression>
  RowsRef(const Eigen::DenseBase<Expression>& expression) : petsc::ConstTallRef(expression) {}
  RowsRef(const Rows<Kind>& rows) : petsc::ConstTallRef(static_cast<const petsc::Tall&>(rows)) {}
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

}  // namespace ritz::mesh
