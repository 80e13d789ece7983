// A file beside the model that appears whole or not at all.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <optional>
#include <string>

#include "ritz/files/part_file.hpp"

namespace ritz::app {

/// A files::PartFile of rank 0, whose name all ranks know.
class PendingFile {
 public:
  /// Throws as files::PartFile does. *Collective*.
  PendingFile(MPI_Comm comm, const std::filesystem::path& path);

  const std::filesystem::path& part() const { return part_; }

  /// Rank 0's text. Throws NumericalError when the disk does not take it. *Collective*.
  void write(const std::string& text) const;
  void finish() const;  ///< Brings it to the disk: its writer has closed it. *Collective*.
  void publish();       ///< *Collective*.

 private:
  MPI_Comm comm_;
  std::optional<files::PartFile> file_;  ///< on rank 0
  std::filesystem::path part_;
};

}  // namespace ritz::app
