// Degrees of freedom: three displacements a vertex, less those that a support fixes.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ritz/mesh/bounding_box.hpp"
#include "ritz/mesh/mesh.hpp"
#include "ritz/mesh/rows.hpp"

namespace ritz::mesh {

inline constexpr int components = 3;  ///< of the displacement of a vertex of a solid

/// What is fixed where: a named set or a coordinate box, and which components.
struct Fixed {
  std::variant<std::string, Region3> where;
  std::array<bool, components> fixed = {true, true, true};
  std::string text;                            ///< as the user wrote it, for messages
  std::optional<std::string> whole_name = {};  ///< a set whose name ends like components: all of them, if it exists
};

enum class FileSupports { used, ignored };

/// The numbering of free degrees of freedom: those of a rank are contiguous, vertex by vertex.
struct Dofs {
  MPI_Comm comm = MPI_COMM_NULL;
  Index total = 0;
  Index first = 0;  ///< the first that this rank owns
  int owned = 0;
  int block = components;      ///< 3 where every vertex is wholly free or wholly fixed, else 1
  std::vector<Index> numbers;  ///< 3 a local vertex: global number, or -1 where fixed
  std::uint64_t checksum = 0;  ///< of what is fixed; the same on any number of ranks

  Index number(int vertex, int component) const {
    return numbers[static_cast<std::size_t>(components * vertex + component)];
  }
  bool fixed(int vertex, int component) const { return number(vertex, component) < 0; }
};

/// Throws InputError on all ranks for a set that does not exist (naming the nearest) or that is one of several, a box
/// without vertices, or when nothing is left free. *Collective*.
Dofs number(const Mesh& mesh, const std::vector<Fixed>& supports, FileSupports file_supports);

/// The displacement of vertex v, or what else there is of it: its rows among rows of vertices.
template <class Vertexwise>
auto at_vertex(Vertexwise&& rows, Eigen::Index v) {
  return rows.template middleRows<components>(components * v);
}

/// The block of vertices a and b in a matrix of a cell.
template <class Matrix>
auto at_vertices(Matrix&& matrix, Eigen::Index a, Eigen::Index b) {
  return matrix.template block<components, components>(components * a, components * b);
}

/// Rows of free degrees of freedom -> rows of owned vertices: 3 a vertex, zeros at fixed components.
VertexRows to_vertices(const Mesh& mesh, const Dofs& dofs, FreeRef x);

/// The other way: fixed components are left out.
FreeRows from_vertices(const Mesh& mesh, const Dofs& dofs, VertexRef u);

}  // namespace ritz::mesh
