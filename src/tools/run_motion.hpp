// motion.h5: the motion of a body, and motion.xdmf beside it, through which ParaView sees it.
//
//   /points          n x 3       m           vertices at rest, once
//   /vertex_ids      n           1           the mesh file's own numbers
//   /cells           *           1           XDMF's mixed topology: for each cell its XDMF type, then its vertices
//   /frame_times     f           s           of the displacement frames (statics: load fractions, units 1)
//   /displacement    f x n x 3   m           u = U z at those times
//   /frames/I        n x 3       m           a view of /displacement[I], for readers of XDMF that know no hyperslabs
//   /times           N           s           of all states (statics: load fractions, units 1)
//   /z               N x r       sqrt(kg) m  reduced coordinates; of an animated mode its own, N x 1
// The attribute "format" = "ritz-motion 1" stands at the root, "units" at every dataset. Without frames the first six
// and the .xdmf are absent.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ritz/files/part_file.hpp"
#include "ritz/format/handle.hpp"
#include "ritz/model/model.hpp"

namespace ritz::tools {

struct MotionPlan {
  std::int64_t states;
  Eigen::Index columns;  ///< r
  std::vector<double> frame_times;
  std::string time_units;  ///< "s"; of load fractions "1"
};

/// The description of motion file `path`, beside it. Throws InputError where that is `path` itself.
std::filesystem::path xdmf_path(std::filesystem::path path);

class MotionWriter {
 public:
  /// Writes what does not move. Throws InputError when the files cannot be created or a cell has a type that XDMF does
  /// not draw.
  MotionWriter(const std::filesystem::path& path, const model::Geometry& geometry, const MotionPlan& plan);

  /// The next state, the next frame: as many as planned. Throw std::runtime_error when writing fails.
  void state(double t, Eigen::Ref<const Eigen::VectorXd> z);
  void frame(const model::Points& displacement);

  /// Closes the files and brings them to the disk. Throws NumericalError when not all could be written.
  void finish();
  /// Gives the files their names.
  void publish();

 private:
  void begin_frames(const model::Geometry& geometry, const MotionPlan& plan);
  void flush_states();

  files::PartFile part_;
  std::optional<files::PartFile> xdmf_;
  format::File file_;
  format::Dataset times_, z_, displacement_;
  Eigen::VectorXd pending_times_;  ///< states that are not written yet
  model::RowMatrix pending_z_;
  Eigen::Index pending_ = 0;
  hsize_t states_ = 0, frames_ = 0;  ///< written
};

}  // namespace ritz::tools
