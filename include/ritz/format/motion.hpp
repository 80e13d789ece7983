// Writing of motions: motion.h5 of a reduced body and full.h5 of an unreduced one, each with an .xdmf file for ParaView
// beside it. One process writes them. src/format/README.md lists their datasets. What cannot be written is thrown as
// files::fail_to_write does: as a rule NumericalError (a full disk), for a bad name InputError.
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

/// The path of the .xdmf file beside the motion file `path`, which messages call `name` ("--output motion.h5"). Throws
/// InputError when `path` itself ends in .xdmf.
std::filesystem::path xdmf_path(std::filesystem::path path, const std::string& name);

/// Whether a dataset gets a checksum, and of which rows: the three numbers of each vertex, or, as in a model, all
/// numbers of a first index, of which pieces then hold whole ones.
enum class Checked : std::uint8_t { no, by_vertex, by_row };

/// The floating point numbers of a dataset. Numbers that single precision cannot hold become infinite.
enum class Stored : std::uint8_t { float64, float32 };

/// A dataset of floats that is written in order, piece by piece.
class NumberStream {
 public:
  using Extent = std::vector<hsize_t>;

  NumberStream() = default;
  /// Creates the dataset with the attribute "units". Pieces may end within a row (all numbers of one first index) only
  /// if the dataset has at most two dimensions.
  NumberStream(hid_t file, const std::string& name, Extent shape, const std::string& units,
               Checked checked = Checked::no, Stored stored = Stored::float64);

  explicit operator bool() const { return static_cast<bool>(dataset_); }
  const Extent& shape() const { return shape_; }
  Stored stored() const { return stored_; }
  /// Appends the numbers that follow.
  void append(std::span<const double> piece);
  /// Writes what is pending and the checksum, and closes the dataset.
  void close();

 private:
  void write(std::span<const double> piece);
  hsize_t checked_row() const;  ///< numbers in a row of the checksum

  Dataset dataset_;
  Extent shape_;
  Checked checked_ = Checked::no;
  Stored stored_ = Stored::float64;
  std::vector<double> pending_;  ///< small pieces that are not written yet
  std::uint64_t written_ = 0;    ///< how many numbers are written
  std::uint64_t sum_ = 0;        ///< the checksum of those
};

/// The cells and vertices of the moving body, which are the same in all frames.
struct StillBody {
  std::int64_t vertices = 0, cells = 0;
  std::span<const std::int64_t> topology;    ///< of all cells, as mixed_topology returns it
  std::span<const std::int64_t> vertex_ids;  ///< the mesh file's own number of each vertex
};

/// What motion.h5 and full.h5 have in common: part files that take their names when they are complete, and the frames
/// for ParaView.
class MotionFile {
 public:
  /// Creates the part file. Throws InputError or NumericalError when it cannot be created.
  explicit MotionFile(const std::filesystem::path& path);

  hid_t file() const { return file_.get(); }
  /// Writes cells, vertex numbers and frame times (not the points), makes each index of the first dimension of the
  /// dataset `frames`, called `name`, visible as one frame, and writes the .xdmf.
  void show_frames(const StillBody& body, std::span<const double> frame_times, const std::string& time_units,
                   const std::string& name, const NumberStream& frames);
  /// Closes the files and flushes them to the disk.
  void finish();
  /// Renames the part files to their final names.
  void publish();

 private:
  files::PartFile part_;
  std::optional<files::PartFile> xdmf_;
  File file_;
};

/// The sizes and times of a reduced motion, known before the run.
struct MotionPlan {
  std::int64_t states;   ///< number of states
  Eigen::Index columns;  ///< r
  std::vector<double> frame_times;
  std::string time_units;           ///< "s"; in statics "1", as the times are load fractions
  std::string model_checksum = {};  ///< coordinates_checksum of the model; empty: nothing can start from the motion
  Stored frames = Stored::float32;  ///< the numbers of the frames, which are for drawing
};

/// The end of a reduced motion, from which another run can continue.
struct ReducedState {
  std::string integrator;                 ///< whose columns `history` has
  std::string scene_checksum;             ///< of what is done to the body
  std::int64_t steps = 0;                 ///< steps since t = 0
  double last_step = 0;                   ///< length of the last part of a step, s
  Eigen::MatrixXd history;                ///< r rows, as runtime::State has them: z, z', ...
  std::map<std::string, double> numbers;  ///< the balance of energy by name, J; empty for linear motions
};

/// Writes motion.h5, for a body that moves by u = U z.
class ReducedMotion {
 public:
  /// Writes points, cells and times. Throws InputError when the files cannot be created or a cell has a type that XDMF
  /// cannot draw.
  ReducedMotion(const std::filesystem::path& path, const model::Geometry& geometry, const MotionPlan& plan);

  /// Appends the next state: t in s or load fractions, z and z' of r numbers. To be called plan.states times.
  void state(double t, Eigen::Ref<const Eigen::VectorXd> z, Eigen::Ref<const Eigen::VectorXd> velocity);
  /// Appends the next frame, n_stored x 3, m. To be called once for each of plan.frame_times.
  void frame(const model::Points& displacement);
  /// Writes the end of the motion.
  void keep(const ReducedState& state);
  void finish();
  void publish() { file_.publish(); }

 private:
  MotionFile file_;
  NumberStream times_, z_, velocity_, displacement_;
};

/// The times of an unreduced motion, known before the run.
struct FullPlan {
  std::vector<double> times;        ///< of all states
  std::vector<double> frame_times;  ///< of the frames among them
  std::string time_units;           ///< "s"; in statics "1", as the times are load fractions
};

enum class StateKind : std::uint8_t { at_rest, moving };

/// The last state, from which another run can continue, apart from its three vectors.
struct StateRecord {
  StateKind kind = StateKind::moving;
  std::string integrator;                 ///< the method that computed the stored acceleration; "none" at rest
  std::string problem_checksum;           ///< checksum of mesh, materials and supports
  std::map<std::string, double> numbers;  ///< by name: t (s), kinetic, elastic, work, dissipated and start (J)
};

/// The arrays of full.h5 with three numbers for each vertex.
enum class VertexArray : std::uint8_t { points, displacement, velocity, acceleration };

/// Writes full.h5. Its large arrays are appended to in pieces, in the vertex order of the mesh file.
class FullMotion {
 public:
  /// Creates the part file and writes the times. Throws as the constructor of MotionFile does.
  FullMotion(const std::filesystem::path& path, std::int64_t vertices, const FullPlan& plan);

  /// Writes cells, vertex numbers and frame times (not the points), and the .xdmf. To be called before the first frame,
  /// if the plan has frames.
  void begin_frames(const StillBody& body, const FullPlan& plan);
  /// The dataset of the frames: append one vector of 3n numbers (m, three for each vertex) for each frame.
  NumberStream& frames() { return frames_; }
  /// Writes the last state, before its three vectors.
  void keep(const StateRecord& state);
  /// Creates an array, n x 3, to be appended to and closed: m, m/s or m/s².
  NumberStream array(VertexArray which) const;
  void finish();
  void publish() { file_.publish(); }

 private:
  MotionFile file_;
  hsize_t vertices_;
  NumberStream frames_;
};

}  // namespace ritz::format
