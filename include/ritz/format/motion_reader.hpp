// What another run reads from an unreduced motion: its frames as snapshots, and its last state.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "ritz/format/motion.hpp"
#include "ritz/format/stored_file.hpp"

namespace ritz::format {

/// Reads the rows of /snapshots, of full.h5 or of any file that has such a dataset (see Storage::foreign). Read them
/// from the first to the last: the last one verifies the checksum, if the dataset has one.
class SnapshotReader : public StoredFile {
 public:
  /// `name` stands for the path in messages. Throws InputError as StoredFile does, and when there is no dataset
  /// /snapshots of two dimensions.
  SnapshotReader(const std::filesystem::path& path, std::string name);

  std::int64_t count() const { return shape_[0]; }
  std::int64_t length() const { return shape_[1]; }  ///< numbers in a snapshot, 3n
  /// Reads snapshot `row`, `length()` numbers. Throws InputError when it cannot be read or the checksum differs.
  void read(std::int64_t row, std::span<double> into);

 private:
  Shape shape_;
  Dataset dataset_;
  std::optional<std::uint64_t> checksum_;
  std::uint64_t sum_ = 0;
};

/// Reads the last state of full.h5.
class LastStateReader : public StoredFile {
 public:
  /// `name` stands for the path in messages. Throws InputError as StoredFile does, and when there is no last state.
  LastStateReader(const std::filesystem::path& path, std::string name);

  /// Throws InputError for values that no state can have.
  StateRecord record() const;
  /// Verifies the checksums of the three vectors, and returns whether all have one; earlier versions did not write
  /// them. Throws InputError for a vector that is missing or damaged.
  bool verify() const;
  /// Displacement (m), velocity (m/s) and acceleration (m/s²) of the vertices [first, first + count) of `vertices` in
  /// all, side by side, count x 9. Throws InputError when the file has another number of vertices or a number is not
  /// finite.
  model::RowMatrix rows(std::int64_t first, std::int64_t count, std::int64_t vertices) const;
};

}  // namespace ritz::format
