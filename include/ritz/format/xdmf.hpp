// The XDMF description of motion.h5, a temporal collection. www.xdmf.org
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ritz/model/model.hpp"

namespace ritz::format {

/// XDMF's mixed topology: for each cell its XDMF type, then its vertices (rows of the points). Throws InputError for a
/// VTK type other than those of fem/cell.hpp.
std::vector<std::int64_t> mixed_topology(const model::DrawnCells& cells);

struct XdmfSize {
  std::int64_t vertices;
  std::int64_t cells;
  std::int64_t topology;  ///< entries of mixed_topology
  int frame_bytes;        ///< of a number of the frames: 4 or 8
};

/// The path in motion.h5 of the displacements of frame `frame`, 0-based.
std::string frame_name(std::size_t frame);

/// The text of the .xdmf file. `file` is the name of motion.h5 without its folder, `times` are the times of the frames.
std::string xdmf_text(const std::string& file, const XdmfSize& size, std::span<const double> times);

}  // namespace ritz::format
