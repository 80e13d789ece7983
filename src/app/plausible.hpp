// Whether a body's size, mass and materials can be what its user meant, or are numbers in other units.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "ritz/config/config.hpp"

namespace ritz::app {

/// In SI.
struct Extent {
  Eigen::Vector3d size;  ///< of the bounding box, m
  double mass;           ///< kg
};

/// *Collective*.
Extent extent(const mesh::Mesh& mesh, const fem::Materials& materials);

/// "size 1 x 0.1 x 0.06 m, mass 46.8 kg, first frequency 83.6 Hz": what tells a person that units were mixed up.
std::string size_line(const Extent& extent, const model::Modes& modes);

/// One sentence where no solid has the constants of a region (stiffness, density, √(E/ρ)), one where a body whose units
/// nobody stated weighs over 1000 t, one where a body stated in millimetres is under .3 mm long. Each names the units
/// that would make the numbers plausible, where there are such.
std::vector<std::string> unit_warnings(const Extent& extent, const std::vector<mesh::Region>& regions,
                                       const fem::Materials& materials, const config::Config& config);

}  // namespace ritz::app
