// What another run reads from a motion: of an unreduced one its frames as snapshots, and its last state; of a reduced
// one its states, and its end.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

/// Reads motion.h5. Everything that is read is compared with its checksum.
class ReducedMotionReader : public StoredFile {
 public:
  /// `name` stands for the path in messages. Throws InputError as StoredFile does, and for a file that ritz-run did not
  /// write, or that an earlier one wrote without velocities.
  ReducedMotionReader(const std::filesystem::path& path, std::string name);

  /// coordinates_checksum of the model whose coordinates move. Throws InputError for the motion of a mode.
  std::string model_checksum() const;
  /// Of all states, s (of statics load fractions).
  const std::vector<double>& times() const { return times_; }
  /// The state at time `time`, to 1e-9 of the motion's length; without a time the last one. Throws InputError when
  /// there is none.
  std::size_t index_at(std::optional<double> time) const;
  /// z and z' of state `index`, r x 2, √kg m and √kg m/s.
  Eigen::MatrixXd state(std::size_t index) const;
  /// The end of the motion. Throws InputError for statics, which have none, and for values that no motion can have.
  ReducedState end() const;

 private:
  std::vector<double> times_;
  Shape shape_;  ///< of z
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
