// full.h5, the motion of the unreduced body, and full.xdmf for ParaView beside it: written by rank 0, slice by slice in
// the order of the mesh file. And its last state, which all ranks read.
#pragma once
#include <map>
#include <optional>

#include "ritz/app/file_geometry.hpp"
#include "ritz/format/motion.hpp"

namespace ritz::app {

using format::FullPlan;
using format::StateKind;

/// The last state of a run. Vectors have rows of owned vertices.
struct LastState {
  StateKind kind = StateKind::moving;
  std::string integrator;                 ///< the method that computed `a`; "none" at rest
  std::map<std::string, double> numbers;  ///< t (s) and energies (J), by name
  mesh::VertexRows u, v, a;               ///< m, m/s, m/s²
};

class FullFile {
 public:
  /// *Collective*. Creates the files and writes everything except frames and the last state. Throws InputError when the
  /// files cannot be created.
  FullFile(const std::filesystem::path& path, const mesh::Mesh& mesh, const fem::Materials& materials,
           const FullPlan& plan);

  /// *Collective*. Appends a frame (m, rows of owned vertices), as many times as planned.
  void frame(mesh::VertexRef u);

  /// *Collective*. Stores the last state.
  void keep(const LastState& state, const std::string& problem_checksum);

  /// *Collective*. Closes the files and flushes them to the disk.
  void finish();
  /// *Collective*. Renames the files to their final names.
  void publish();

 private:
  void begin_frames(const FullPlan& plan);
  void write(format::VertexArray array, const parallel::RowMatrix& slice);

  MPI_Comm comm_;
  FileGeometry order_;
  std::optional<format::FullMotion> file_;  ///< on rank 0
};

/// *Collective*. Verifies the checksums of the last state, which rank 0 reads; to be called before read_last_state.
/// `name` stands for the path in messages. Returns a warning if the file has no checksums, else an empty text. Throws
/// InputError on all ranks for a damaged file.
std::string verify_last_state(MPI_Comm comm, const std::filesystem::path& path, const std::string& name);

/// *Collective*. Reads the last state of an earlier run. Throws InputError on all ranks when the file was not written
/// by ritz-full, or belongs to another problem.
LastState read_last_state(const std::filesystem::path& path, const std::string& name, const mesh::Mesh& mesh,
                          const std::string& problem_checksum);

}  // namespace ritz::app
