// Cubatures of bodies without a mesh: random displacement gradients of the columns of U at some points.
#pragma once
#include <vector>

#include "ritz/model/model.hpp"

namespace ritz::test {

struct SampleCubature {
  model::Cubature cubature;
  std::vector<model::RegionMaterial> materials;
  model::Polynomial polynomial;  ///< of the same points, with St. Venant-Kirchhoff laws of the constants at rest
};

/// One of each law, Young's modulus near 1e3 Pa at rest; with isotropic constants at rest alone.
std::vector<model::RegionMaterial> all_isotropic_laws();

/// Cells of one, two, three, one, ... points, as many as make `points`, that belong to the materials in turn; random
/// weights between 1/2 and 3/2 where `weights` is so, else all of 1. |z| near 1 is a large deformation.
enum class SampleWeights { one, random };
SampleCubature sample_cubature(Eigen::Index r, Eigen::Index points, std::vector<model::RegionMaterial> materials,
                               model::Integrand integrand, SampleWeights weights = SampleWeights::random);

}  // namespace ritz::test
