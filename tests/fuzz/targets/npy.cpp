// Snapshots in NumPy's format, for a cube.
#include "fuzz/parallel_setting.hpp"
#include "fuzz/target.hpp"
#include "ritz/app/snapshots.hpp"

namespace ritz::fuzz {

void read_input(Bytes input) {
  static const Cube cube;
  const auto snapshots = app::read_snapshots(as_file(input, "some.npy"), cube.mesh, cube.dofs);
  if (snapshots.rows() != cube.dofs.owned || snapshots.cols() < 1) finding("snapshots of another size");
  if (!snapshots.allFinite()) finding("a snapshot that is not finite");
}

}  // namespace ritz::fuzz
