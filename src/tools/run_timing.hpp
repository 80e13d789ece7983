// What each step cost, as a table: --timing FILE.csv.
#pragma once
#include <filesystem>

#include "ritz/world/run.hpp"
#include "run_table.hpp"

namespace ritz::tools {

/// t,microseconds,iterations,rejected with a row a step.
class TimingWriter {
 public:
  /// Throws InputError when the file cannot be created.
  explicit TimingWriter(const std::filesystem::path& path);

  void row(const world::StepCost& step);
  TableFile& table() { return table_; }

 private:
  TableFile table_;
};

}  // namespace ritz::tools
