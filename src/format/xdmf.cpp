#include "ritz/format/xdmf.hpp"

#include <iomanip>
#include <sstream>

#include "ritz/base/error.hpp"
#include "ritz/fem/cell.hpp"
#include "ritz/format/schema.hpp"

namespace ritz::format {
namespace {

std::int64_t xdmf_type(std::uint8_t vtk) {
  if (const auto cell = fem::cell_of_vtk(vtk)) return fem::shape(*cell).xdmf;
  if (const auto face = fem::face_of_vtk(vtk)) return fem::shape(*face).xdmf;
  throw InputError("the model has cells of VTK type " + std::to_string(vtk) + ", which cannot be drawn");
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      default: result += c;
    }
  }
  return result;
}

}  // namespace

std::vector<std::int64_t> mixed_topology(const model::DrawnCells& cells) {
  std::vector<std::int64_t> topology;
  topology.reserve(cells.vtk_types.size() + cells.vertices.size());
  for (std::size_t cell = 0; cell < cells.vtk_types.size(); ++cell) {
    topology.push_back(xdmf_type(cells.vtk_types[cell]));
    topology.insert(topology.end(), cells.vertices.begin() + cells.offsets[cell],
                    cells.vertices.begin() + cells.offsets[cell + 1]);
  }
  return topology;
}

std::string frame_name(std::size_t frame) { return schema::join(schema::motion::frames, std::to_string(frame)); }

std::string xdmf_text(const std::string& file, const XdmfSize& size, std::span<const double> times) {
  const std::string source = escaped(file) + ":/";
  const auto numbers = [&](int bytes) {
    return " NumberType=\"Float\" Precision=\"" + std::to_string(bytes) + "\" Format=\"HDF\">" + source;
  };
  std::ostringstream out;
  out << std::setprecision(17) << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
      << "<Grid Name=\"motion\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t frame = 0; frame < times.size(); ++frame) {
    out << "<Grid Name=\"body\" GridType=\"Uniform\">\n<Time Value=\"" << times[frame] << "\"/>\n"
        << "<Topology TopologyType=\"Mixed\" NumberOfElements=\"" << size.cells << "\"><DataItem Dimensions=\""
        << size.topology << "\" NumberType=\"Int\" Precision=\"8\" Format=\"HDF\">" << source
        << "cells</DataItem></Topology>\n"
        << "<Geometry GeometryType=\"XYZ\"><DataItem Dimensions=\"" << size.vertices << " 3\"" << numbers(8)
        << "points</DataItem></Geometry>\n"
        << "<Attribute Name=\"displacement\" AttributeType=\"Vector\" Center=\"Node\">"
        << "<DataItem Dimensions=\"" << size.vertices << " 3\"" << numbers(size.frame_bytes)
        << frame_name(frame).substr(1) << "</DataItem></Attribute>\n</Grid>\n";
  }
  out << "</Grid>\n</Domain>\n</Xdmf>\n";
  return out.str();
}

}  // namespace ritz::format
