// The VTKHDF 1.0 group of each body, through which ParaView sees it: hard links to what the parts have written, no
// copies. ParaView looks for one such group at the root of a file, where the first body's stands.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "ritz/files/part_file.hpp"
#include "ritz/format/parts.hpp"

namespace ritz::format {

/// *Collective*: the unstructured grid of a body whose geometry is written.
void write_grid(const ModelWriter& out, std::string_view body, const GeometrySlices& slices);
/// *Collective*: shows the dataset `path` (n x 3) as a point vector `name` of a body. Without a grid nothing is shown.
void write_point_vector(const ModelWriter& out, std::string_view body, const std::string& path,
                        const std::string& name);

/// The small file MODEL.BODY.vtkhdf beside the file `model`, ready to get its name: an external link to the VTKHDF
/// group of one of several bodies, which is written below `home`. `body` is a link name. Throws as files::PartFile
/// does.
files::PartFile view_file(const std::filesystem::path& model, const std::string& body, const std::string& home);

}  // namespace ritz::format
