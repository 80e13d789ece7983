// full.h5, the motion of the unreduced body, and full.xdmf beside it for ParaView: written by one rank, by slices in
// the mesh file's order; and its last state, read again by all.
#pragma once
#include <map>
#include <optional>

#include "ritz/app/file_geometry.hpp"
#include "ritz/format/motion.hpp"

namespace ritz::app {

using format::FullPlan;
using format::StateKind;

/// Where a run stopped. Vectors: rows of owned vertices.
struct LastState {
  StateKind kind = StateKind::moving;
  std::string integrator;                 ///< whose acceleration `a` is; "none" at rest
  std::map<std::string, double> numbers;  ///< t and energies, by name
  mesh::VertexRows u, v, a;
};

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
  void begin_frames(const FullPlan& plan);
  void write(format::VertexArray array, const parallel::RowMatrix& slice);

  MPI_Comm comm_;
  FileGeometry order_;
  std::optional<format::FullMotion> file_;  ///< on rank 0
};

/// Verifies the checksums of the last state, on rank 0, before read_last_state. Throws InputError on all ranks for a
/// damaged file; the warning of a file that has none, empty elsewhere. *Collective*.
std::string verify_last_state(MPI_Comm comm, const std::filesystem::path& path);

/// The last state of an earlier run. Throws InputError on all ranks when the file is none of ritz-full's, or of another
/// problem. *Collective*.
LastState read_last_state(const std::filesystem::path& path, const mesh::Mesh& mesh,
                          const std::string& problem_checksum);

}  // namespace ritz::app
