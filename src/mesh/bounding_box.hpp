// The box around a mesh.
#pragma once
#include "ritz/mesh/mesh.hpp"

namespace ritz::mesh {

/// A box [low, high] of coordinates, m.
struct Region3 {
  Eigen::Vector3d low, high;

  Eigen::Vector3d middle() const { return (low + high) / 2; }
  Eigen::Vector3d size() const { return high - low; }
};

/// The smallest box that holds all vertices, to the last bit the same on any number of ranks. *Collective*.
Region3 bounding_box(const Mesh& mesh);

}  // namespace ritz::mesh
