// The VTKHDF 1.0 group of each body, by which ParaView shows it: hard links to datasets that exist, without copies.
// ParaView reads only the group at the root of a file, which is that of the first body.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "ritz/files/part_file.hpp"
#include "ritz/format/parts.hpp"

namespace ritz::format {

/// *Collective*. Writes the unstructured grid of a body whose geometry is written.
void write_grid(const ModelWriter& out, std::string_view body, const GeometrySlices& slices);
/// *Collective*. Shows the dataset `path` (n x 3) as a point vector `name` of a body; does nothing if the body has no
/// grid.
void write_point_vector(const ModelWriter& out, std::string_view body, const std::string& path,
                        const std::string& name);

/// The file MODEL.BODY.hdf beside the file `model`, written but not published: it contains an external link to the
/// VTKHDF group of one of several bodies, which is stored in the group `home`. `body` is a link name. Throws as
/// files::PartFile does.
files::PartFile view_file(const std::filesystem::path& model, const std::string& body, const std::string& home);

}  // namespace ritz::format
