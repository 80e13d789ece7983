#include "ritz/stages/fixed_vectors.hpp"

#include "ritz/base/random.hpp"

namespace ritz::stages {

mesh::FreeRows fixed_vectors(const mesh::Mesh& mesh, const mesh::Dofs& dofs, int columns, std::uint64_t stream) {
  algebra::Tall x(dofs.owned, columns);
  for (int v = 0; v < mesh.owned; ++v)
    for (int c = 0; c < mesh::components; ++c) {
      if (dofs.fixed(v, c)) continue;
      const auto index =
          static_cast<std::uint64_t>(mesh::components * mesh.file_positions[static_cast<std::size_t>(v)] + c);
      for (int j = 0; j < columns; ++j)
        x(dofs.number(v, c) - dofs.first, j) = uniform(stream + static_cast<std::uint64_t>(j), index);
    }
  return x;
}

}  // namespace ritz::stages
