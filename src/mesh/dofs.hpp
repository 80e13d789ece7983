// Degrees of freedom: the three displacement components of each vertex, without those that supports fix.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ritz/mesh/mesh.hpp"
#include "ritz/mesh/rows.hpp"

namespace ritz::mesh {

/// A support: a named set or a coordinate box, and the components that are fixed there.
struct Fixed {
  std::variant<std::string, Region3> where;
  std::array<bool, components> fixed = {true, true, true};  ///< along x, y, z
  std::string text;                                         ///< as the user wrote it, for messages
  std::optional<std::string> whole_name = {};  ///< a set whose name ends like components: all of them, if it exists
};

enum class FileSupports { used, ignored };

/// The numbering of the free degrees of freedom. Those of one rank are contiguous and ordered by vertex.
struct Dofs {
  MPI_Comm comm = MPI_COMM_NULL;
  Index total = 0;             ///< on all ranks
  Index first = 0;             ///< the first number that this rank owns
  int owned = 0;               ///< how many this rank owns
  int block = components;      ///< 3 if every vertex is either free or fixed in all components, else 1
  std::vector<Index> numbers;  ///< three for each local vertex: the global number, or -1 if fixed
  std::uint64_t checksum = 0;  ///< of the fixed degrees of freedom; the same on any number of ranks

  Index number(int vertex, int component) const {
    return numbers[static_cast<std::size_t>(components * vertex + component)];
  }
  bool fixed(int vertex, int component) const { return number(vertex, component) < 0; }
};

/// *Collective*. Numbers the free degrees of freedom. Throws InputError on all ranks for a set that does not exist
/// (naming the nearest one) or whose name is ambiguous, for a box without vertices, and when no degree of freedom is
/// free.
Dofs number(const Mesh& mesh, const std::vector<Fixed>& supports, FileSupports file_supports);

/// Whether a component is fixed: three entries for each vertex, owned ones first; only
/// theirs are read.
using Mask = std::vector<std::uint8_t>;

/// *Collective*. Numbers the degrees of freedom that `fixed` leaves free, of which there may be none.
Dofs number_free(const Mesh& mesh, const Mask& fixed);

/// From rows of free degrees of freedom to rows of owned vertices, three for each vertex, with zeros at fixed
/// components.
VertexRows to_vertices(const Mesh& mesh, const Dofs& dofs, FreeRef x);

/// From rows of owned vertices to rows of free degrees of freedom; fixed components are left out.
FreeRows from_vertices(const Mesh& mesh, const Dofs& dofs, VertexRef u);

}  // namespace ritz::mesh
