// A folder that rank 0 makes for all ranks, gone at the end.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "ritz/parallel/comm.hpp"

namespace ritz::test {

/// Making and losing it are *Collective*.
class SharedFolder {
 public:
  SharedFolder() {
    std::string name = "ritz_test_" + std::to_string(getpid());
    parallel::broadcast(MPI_COMM_WORLD, name);
    path_ = std::filesystem::temp_directory_path() / name;
    if (parallel::rank(MPI_COMM_WORLD) == 0) std::filesystem::create_directory(path_);
    MPI_Barrier(MPI_COMM_WORLD);
  }
  ~SharedFolder() {
    MPI_Barrier(MPI_COMM_WORLD);
    if (parallel::rank(MPI_COMM_WORLD) == 0) std::filesystem::remove_all(path_);
  }
  SharedFolder(const SharedFolder&) = delete;
  SharedFolder& operator=(const SharedFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  /// A file that rank 0 writes; its path. *Collective*.
  std::string file(const std::string& name, const std::string& text) const {
    if (parallel::rank(MPI_COMM_WORLD) == 0) std::ofstream(path_ / name) << text;
    MPI_Barrier(MPI_COMM_WORLD);
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_;
};

}  // namespace ritz::test
