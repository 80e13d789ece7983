// The VTKHDF 1.0 group through which ParaView sees a model: hard links to what the parts have written, no copies.
// One grid a file: the body whose geometry is written first.
#pragma once
#include <string>

#include "ritz/format/parts.hpp"

namespace ritz::format {

/// *Collective*: the unstructured grid of the geometry in `group`.
void write_grid(const ModelWriter& out, const std::string& group, const GeometrySlices& slices);
/// *Collective*: shows the dataset `path` (n x 3) as a point vector `name`. Without a grid nothing is shown.
void write_point_vector(const ModelWriter& out, const std::string& path, const std::string& name);

}  // namespace ritz::format
