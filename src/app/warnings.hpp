// Warnings before a long run, and the size and mass of a body, which show when numbers are in other units than was
// said.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// The size and mass of a body, in SI units.
struct Extent {
  Eigen::Vector3d size;  ///< of the bounding box, m
  double mass;           ///< kg
};

/// *Collective*. Computes the size and the mass of the body.
Extent extent(const mesh::Mesh& mesh, const fem::Materials& materials);

/// "size 1 x 0.1 x 0.06 m, mass 46.8 kg, first frequency 83.6 Hz": shows the user when units were mixed up.
std::string size_line(const Extent& extent, const model::Modes& modes);

/// Warnings, one sentence each: when no solid has the constants of a region (stiffness, density, √(E/ρ)); when a body
/// whose units were not given weighs over 1000 t; when a body given in millimetres is shorter than 0.3 mm. Each names
/// the units that would make the numbers plausible, if there are any.
std::vector<std::string> unit_warnings(const Extent& extent, const std::vector<mesh::Region>& regions,
                                       const fem::Materials& materials, const config::Config& config);

/// *Collective*. The mesh's own warnings, locking of linear tetrahedra, units that look mixed up, a body without
/// supports although the user did not ask for a free one, a slow BLAS; one sentence each.
std::vector<std::string> warnings(const config::Config& config, const mesh::Mesh& mesh, const mesh::Dofs& dofs,
                                  const fem::Materials& materials);

}  // namespace ritz::app
