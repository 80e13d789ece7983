// full.h5: the motion of the unreduced body, laid out as ritz-run's motion.h5, and full.xdmf beside it for ParaView.
//
// clang-format off
//   /points, /vertex_ids, /cells, /times, /frame_times   as in motion.h5
//   /snapshots       f x 3n      m   a frame a row: full vectors in the mesh file's order of vertices, x y z together;
//                    its checksum is that of a model's datasets, taken over rows of three numbers, a vertex each
//   /displacement    f x n x 3   m   a view of /snapshots
//   /frames/I        n x 3       m   a view of row I of it
//   /state/displacement, velocity, acceleration   n x 3   the last state, from which -restart goes on; its attributes
//                    t, kinetic, elastic, work, dissipated, start, kind (at_rest: of statics; moving) and
//                    problem_checksum say when and of what. They have checksums as a model's datasets
// clang-format on
// One rank writes, by slices in the mesh file's order.
#pragma once
#include <map>
#include <optional>

#include "ritz/app/file_geometry.hpp"
#include "ritz/app/pending_file.hpp"
#include "ritz/format/handle.hpp"

namespace ritz::app {

/// What stands in the file before anything moves.
struct FullPlan {
  std::vector<double> times;        ///< of all states
  std::vector<double> frame_times;  ///< of the frames among them
  std::string time_units;           ///< "s"; of load fractions "1"
};

enum class StateKind { at_rest, moving };

/// Where a run stopped. Vectors: rows of owned vertices.
struct LastState {
  StateKind kind = StateKind::moving;
  std::string integrator;                 ///< whose acceleration `a` is; "none" at rest
  std::map<std::string, double> numbers;  ///< t and energies, by name
  mesh::VertexRows u, v, a;
};

/// The description of motion file `path`, beside it. Throws InputError where that is `path` itself.
std::filesystem::path xdmf_path(std::filesystem::path path);

class FullFile {
 public:
  /// Writes what does not move. Throws InputError when the files cannot be created. *Collective*.
  FullFile(const std::filesystem::path& path, const mesh::Mesh& mesh, const fem::Materials& materials,
           const FullPlan& plan);

  /// The next frame, rows of owned vertices; as many as planned. *Collective*.
  void frame(mesh::VertexRef u);

  /// *Collective*.
  void keep(const LastState& state, const std::string& problem_checksum);

  /// Closes the files and brings them to the disk. *Collective*.
  void finish();
  /// Gives them their names. *Collective*.
  void publish();

 private:
  void begin_frames(const std::filesystem::path& path, const FullPlan& plan);
  void write_vertices(const std::string& name, const parallel::RowMatrix& slice, const std::string& units);

  MPI_Comm comm_;
  FileGeometry order_;
  PendingFile part_;
  std::optional<PendingFile> xdmf_;
  std::size_t frames_planned_, frames_ = 0;
  std::uint64_t snapshots_sum_ = 0;  ///< on rank 0
  format::File file_;                ///< open on rank 0
  format::Dataset snapshots_;
};

/// Verifies the checksums of the last state, on rank 0, before read_last_state. Throws InputError on all ranks for a
/// damaged file; the warning of a file that has none, empty elsewhere. *Collective*.
std::string verify_last_state(MPI_Comm comm, const std::filesystem::path& path);

/// The last state of an earlier run. Throws InputError on all ranks when the file is none of ritz-full's, or of another
/// problem. *Collective*.
LastState read_last_state(const std::filesystem::path& path, const mesh::Mesh& mesh,
                          const std::string& problem_checksum);

}  // namespace ritz::app
