// A list of vertices, for a mesh of a hundred.
#include <algorithm>

#include "fuzz/target.hpp"
#include "ritz/readers/file_mesh.hpp"

namespace ritz::fuzz {

void read_input(Bytes input) {
  constexpr readers::Index count = 100;
  const auto vertices = readers::read_bou(as_file(input, "list.bou"), count);
  if (!std::is_sorted(vertices.begin(), vertices.end())) finding("vertices that do not ascend");
  if (!vertices.empty() && (vertices.front() < 0 || vertices.back() >= count)) finding("a vertex that there is not");
}

}  // namespace ritz::fuzz
