// A text file that all ranks write.
#pragma once
#include <mpi.h>

#include <concepts>
#include <filesystem>
#include <fstream>
#include <string>

namespace ritz::parallel {

/// Text in the order of ranks, in a file that rank 0 writes. No rank holds more than a piece of it at a time.
class RankedText {
 public:
  RankedText(MPI_Comm comm, const std::filesystem::path& path);

  /// Adds text of rank 0 before everything that is added from now on; the argument of the other ranks is ignored.
  void header(const std::string& text);

  /// Adds a number, in the shortest digits that are read back as the same double, and the character `after`.
  void add(double value, char after);
  void add(std::integral auto value, char after) { append(std::to_string(value) + after); }

  /// *Collective*. Ends a part, to which each rank has added its text: the ranks' texts follow one another, and the
  /// next part follows them.
  void end_part();

  /// *Collective*. Closes the file. Throws NumericalError on all ranks when the disk did not take everything.
  void close();

 private:
  void append(std::string_view text);
  void flush();
  void send();
  bool receive(int from);

  MPI_Comm comm_;
  std::filesystem::path path_;
  std::ofstream file_;
  int error_ = 0;  ///< errno of the first write that failed
  std::string text_;
};

}  // namespace ritz::parallel
