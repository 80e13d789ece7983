// What another run reads of an unreduced motion: its frames as snapshots, and its last state.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "ritz/format/motion.hpp"
#include "ritz/format/stored_file.hpp"

namespace ritz::format {

/// The rows of /snapshots, of full.h5 or of any file of that dataset (see Storage::foreign). They are read from the
/// first to the last, with which the checksum is verified where there is one.
class SnapshotReader : public StoredFile {
 public:
  /// `name` stands for the path in messages. Throws InputError, as StoredFile and where there is no such dataset of two
  /// dimensions.
  SnapshotReader(const std::filesystem::path& path, std::string name);

  std::int64_t count() const { return shape_[0]; }
  std::int64_t length() const { return shape_[1]; }  ///< of a snapshot
  /// Reads a whole snapshot. Throws InputError.
  void read(std::int64_t row, std::span<double> into);

 private:
  Shape shape_;
  Dataset dataset_;
  std::optional<std::uint64_t> checksum_;
  std::uint64_t sum_ = 0;
};

/// The last state in full.h5.
class LastStateReader : public StoredFile {
 public:
  /// `name` stands for the path in messages. Throws InputError, as StoredFile and where there is no last state.
  LastStateReader(const std::filesystem::path& path, std::string name);

  /// Throws InputError for what no state can be.
  StateRecord record() const;
  /// Whether all three vectors have checksums, which earlier versions did not write; verifies those that there are.
  /// Throws InputError for a damaged vector.
  bool verify() const;
  /// The vertices [first, first + count) of `vertices` in all: displacement, velocity and acceleration side by side,
  /// count x 9. Throws InputError.
  model::RowMatrix rows(std::int64_t first, std::int64_t count, std::int64_t vertices) const;
};

}  // namespace ritz::format
