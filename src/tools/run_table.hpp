// A table that grows by a row a step and takes its name when it is whole.
#pragma once
#include <fstream>

#include "ritz/files/part_file.hpp"

namespace ritz::tools {

class TableFile {
 public:
  /// Throws InputError when the file cannot be created.
  explicit TableFile(const std::filesystem::path& path);

  /// To which a row is written, 15 digits a number.
  std::ostream& out() { return out_; }
  /// After each row. Throws NumericalError when the disk did not take what it was given so far.
  void check();

  /// Closes it and brings it to the disk. Throws NumericalError when not all could be written.
  void finish();
  void publish() { file_.publish(); }

 private:
  files::PartFile file_;
  std::ofstream out_;
};

}  // namespace ritz::tools
