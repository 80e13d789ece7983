// A file beside the model, which appears completely or not at all.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <optional>
#include <string>

#include "ritz/files/part_file.hpp"

namespace ritz::app {

/// A files::PartFile of rank 0 whose name is known on all ranks.
class PendingFile {
 public:
  /// *Collective*. Creates the file. Throws on all ranks as files::PartFile does.
  PendingFile(MPI_Comm comm, const std::filesystem::path& path);

  const std::filesystem::path& part() const { return part_; }

  /// *Collective*. Writes the text of rank 0. Throws NumericalError when the disk does not take it.
  void write(const std::string& text) const;
  void finish() const;  ///< *Collective*. Flushes the file, which must be closed, to the disk.
  void publish();       ///< *Collective*. Renames it to its final name.

 private:
  MPI_Comm comm_;
  std::optional<files::PartFile> file_;  ///< on rank 0
  std::filesystem::path part_;
};

}  // namespace ritz::app
