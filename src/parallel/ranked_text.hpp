// One text file that all ranks write.
#pragma once
#include <mpi.h>

#include <concepts>
#include <filesystem>
#include <fstream>
#include <string>

namespace ritz::parallel {

/// Text in the order of ranks, in a file of rank 0's. No rank holds more than a piece of it at a time.
class RankedText {
 public:
  RankedText(MPI_Comm comm, const std::filesystem::path& path);

  /// What rank 0 says here stands before all that is added from now on; the others' is not looked at.
  void header(const std::string& text);

  /// A number in the shortest digits that give it again, and a character after it.
  void add(double value, char after);
  void add(std::integral auto value, char after) { append(std::to_string(value) + after); }

  /// This rank has added its part: the next rank's follows, and then the next part. *Collective*.
  void end_part();

  /// Throws NumericalError on all ranks when the disk did not take everything. *Collective*.
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
