// A file beside the model that appears whole or not at all.
#pragma once
#include <mpi.h>

#include <filesystem>
#include <string>

namespace ritz::app {

/// Stands as `path`.part until `publish` gives it its name, over an earlier file of that name; gone if that never
/// comes.
class PendingFile {
 public:
  PendingFile(MPI_Comm comm, const std::filesystem::path& path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& part() const { return part_; }

  /// Rank 0's text. Throws NumericalError when the disk does not take it. *Collective*.
  void write(const std::string& text) const;
  void publish();  ///< *Collective*

 private:
  MPI_Comm comm_;
  std::filesystem::path path_, part_;
  bool published_ = false;
};

}  // namespace ritz::app
