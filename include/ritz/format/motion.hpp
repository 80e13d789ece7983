// The files of motions, as they are written: motion.h5 of a reduced body and full.h5 of an unreduced one, each with an
// .xdmf beside it, through which ParaView sees it. One process writes them. src/format/README.md has their datasets.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ritz/files/part_file.hpp"
#include "ritz/format/handle.hpp"
#include "ritz/model/model.hpp"

namespace ritz::format {

/// The .xdmf beside the motion file `path`, which messages call `name` ("--output motion.h5").
/// Throws InputError where that is `path` itself.
std::filesystem::path xdmf_path(std::filesystem::path path, const std::string& name);

/// Whether a dataset gets a checksum; if so, it is that of a model's datasets, over rows of the three numbers of a
/// vertex.
enum class Checked : std::uint8_t { no, by_vertex };

/// A dataset of 64-bit floats that is written from its first number to its last, piece after piece.
/// All members throw NumericalError when the disk does not take them.
class NumberStream {
 public:
  using Extent = std::vector<hsize_t>;

  NumberStream() = default;
  /// Creates the dataset with the attribute "units". Pieces that are not whole rows (what stands behind the first
  /// index) are taken in up to two dimensions.
  NumberStream(hid_t file, const std::string& name, Extent shape, const std::string& units,
               Checked checked = Checked::no);

  explicit operator bool() const { return static_cast<bool>(dataset_); }
  const Extent& shape() const { return shape_; }
  /// The numbers that follow the last ones.
  void append(std::span<const double> piece);
  /// Closes the dataset, which is then on its way to the disk.
  void close();

 private:
  void write(std::span<const double> piece);

  Dataset dataset_;
  Extent shape_;
  Checked checked_ = Checked::no;
  std::vector<double> pending_;  ///< small pieces, not written yet
  std::uint64_t written_ = 0;    ///< numbers
  std::uint64_t sum_ = 0;        ///< the checksum so far
};

/// The cells and vertices of the body that moves.
struct StillBody {
  std::int64_t vertices = 0, cells = 0;
  std::span<const std::int64_t> topology;  ///< of all cells, as mixed_topology has it
  std::span<const std::int64_t> vertex_ids;
};

/// What both kinds of file have: the names that they get when they are whole, and what draws their frames.
class MotionFile {
 public:
  /// checked: HDF5's own records have checksums, for files that are read again.
  enum class Records : std::uint8_t { plain, checked };
  /// Throws InputError or NumericalError when the file cannot be created.
  MotionFile(const std::filesystem::path& path, Records records);

  hid_t file() const { return file_.get(); }
  /// Writes what does not move but for the points, shows each row of the first dimension of `frames` as a frame, and
  /// makes the .xdmf.
  void show_frames(const StillBody& body, std::span<const double> frame_times, const std::string& time_units,
                   const std::string& name, const NumberStream& frames);
  /// Closes the files and brings them to the disk. Throws NumericalError when not all could be written.
  void finish();
  /// Gives the files their names.
  void publish();

 private:
  files::PartFile part_;
  std::optional<files::PartFile> xdmf_;
  File file_;
};

/// What is known of a reduced motion before anything moves.
struct MotionPlan {
  std::int64_t states;
  Eigen::Index columns;  ///< r
  std::vector<double> frame_times;
  std::string time_units;  ///< "s"; of load fractions "1"
};

/// motion.h5, of a body that moves by u = U z.
class ReducedMotion {
 public:
  /// Writes what does not move. Throws InputError when the files cannot be created or a cell has a type that XDMF does
  /// not draw.
  ReducedMotion(const std::filesystem::path& path, const model::Geometry& geometry, const MotionPlan& plan);

  /// The next state, the next frame: as many as planned.
  void state(double t, Eigen::Ref<const Eigen::VectorXd> z);
  void frame(const model::Points& displacement);
  void finish();
  void publish() { file_.publish(); }

 private:
  MotionFile file_;
  NumberStream times_, z_, displacement_;
};

/// What is known of an unreduced motion before anything moves.
struct FullPlan {
  std::vector<double> times;        ///< of all states
  std::vector<double> frame_times;  ///< of the frames among them
  std::string time_units;           ///< "s"; of load fractions "1"
};

enum class StateKind : std::uint8_t { at_rest, moving };

/// What is said of the last state, from which another run can go on, besides its three vectors.
struct StateRecord {
  StateKind kind = StateKind::moving;
  std::string integrator;                 ///< whose acceleration is stored; "none" at rest
  std::string problem_checksum;           ///< of mesh, materials and supports
  std::map<std::string, double> numbers;  ///< t, kinetic, elastic, work, dissipated and start, by name
};

/// The arrays of three numbers a vertex in full.h5.
enum class VertexArray : std::uint8_t { points, displacement, velocity, acceleration };

/// full.h5, whose large arrays are written in pieces, in the mesh file's order of vertices.
class FullMotion {
 public:
  /// Throws as MotionFile does.
  FullMotion(const std::filesystem::path& path, std::int64_t vertices, const FullPlan& plan);

  /// Writes what does not move but for the points; of a plan with frames, and before them.
  void begin_frames(const StillBody& body, const FullPlan& plan);
  /// The frames, one vector of 3n numbers after another.
  NumberStream& frames() { return frames_; }
  /// The last state, before its three vectors.
  void keep(const StateRecord& state);
  /// An array to be appended to and closed.
  NumberStream array(VertexArray which) const;
  void finish();
  void publish() { file_.publish(); }

 private:
  MotionFile file_;
  hsize_t vertices_;
  NumberStream frames_;
};

}  // namespace ritz::format
