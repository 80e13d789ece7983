// Whether a displaced mesh is still one that could be.
#pragma once
#include <cstdint>

#include "ritz/model/model.hpp"

namespace ritz::tools {

/// How many cells the displacements (n x 3, m) turn inside out: det(I + ∇u) <= 0 at a point of the element's rule.
/// Faces, which stand for cells where only the surface is stored, are not counted.
std::int64_t inside_out(const model::Geometry& geometry, const model::Points& displacement);

}  // namespace ritz::tools
