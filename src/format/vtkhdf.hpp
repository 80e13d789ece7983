// The VTKHDF 1.0 group of each body, by which ParaView shows it: hard links to the geometry, and the columns of U
// as displacements that the eye sees. ParaView reads only the group at the root of a file, which is that of the first
// body.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "ritz/files/part_file.hpp"
#include "ritz/format/parts.hpp"

namespace ritz::format {

/// *Collective*. Writes the unstructured grid of a body whose geometry is written.
void write_grid(const ModelWriter& out, std::string_view body, const GeometrySlices& slices);
/// *Collective*. Shows a column of U as a point vector (n x 3, single precision), with its factor as an attribute;
/// `values` are the column's at the vertices of this rank. Does nothing if the body has no grid.
void write_point_vector(const ModelWriter& out, std::string_view body, const ShownColumn& shown,
                        std::span<const double> values, Slice vertices);

/// The file MODEL.BODY.hdf beside the file `model`, written but not published: it contains an external link to the
/// VTKHDF group of one of several bodies, which is stored in the group `home`. `body` is a link name. Throws as
/// files::PartFile does.
files::PartFile view_file(const std::filesystem::path& model, const std::string& body, const std::string& home);

}  // namespace ritz::format
