// Reads groups, attributes and datasets. Everything unexpected is an InputError that names the file and the path in it.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hdf5.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/format/stored_file.hpp"

namespace ritz::format {

/// Throws InputError "FILE: PATH WHAT; write the model again".
[[noreturn]] void fail(const StoredFile& in, const std::string& path, const std::string& what);
/// Unless `holds`, throws InputError "FILE: PATH: SENTENCE; write the model again".
void require(bool holds, const StoredFile& in, const std::string& path, const std::string& sentence);

/// The names of a group's links in the order in which they were made; none if there is no such group. Throws InputError
/// when one of them is not a hard link.
std::vector<std::string> links(const StoredFile& in, const std::string& group);

/// The group of what a file with a single body has at its root: the root for the first body, the body's own group for
/// every other body.
std::string home(const ModelReader& in, std::string_view body);

std::vector<Index> read_indices(const StoredFile& in, const std::string& object, const char* name);

/// The shape of a dataset of at least one dimension. Throws InputError for what survey() refuses, and for a view.
Shape stored_shape(const StoredFile& in, const std::string& path);

inline constexpr Index any = -1;  ///< in an expected shape: any length

/// A dataset open for reading: numbers or fixed-length texts, in one or more dimensions.
class StoredArray {
 public:
  StoredArray(const StoredFile& in, std::string path);

  const Shape& shape() const { return shape_; }
  Index rows() const { return shape_.front(); }
  std::size_t row_bytes() const;
  hid_t type() const { return type_.get(); }
  hid_t dataset() const { return dataset_.get(); }

  /// Throws InputError unless the shape is `expected` and the type is `type` (if one is given).
  void expect(const Shape& expected, hid_t type) const;
  /// Reads rows [first, first + count) as they are stored, without a check.
  void load(Index first, Index count, void* data) const;
  /// The same, and verifies the checksum if these are all rows.
  void read(Index first, Index count, void* data) const;

 private:
  const StoredFile& in_;
  std::string path_;
  Shape shape_;
  Dataset dataset_;
  Type type_;
};

/// Throws InputError for a number that is not finite.
void require_finite(const StoredFile& in, const std::string& path, std::span<const double> values);

/// Throws InputError for a number that is not finite.
template <class T>
std::vector<T> read_vector(const StoredFile& in, const std::string& path, Index length = any) {
  const StoredArray array(in, path);
  array.expect({length}, hdf5_type<T>());
  std::vector<T> values(static_cast<std::size_t>(array.rows()));
  array.read(0, array.rows(), values.data());
  if constexpr (std::is_same_v<T, double>) require_finite(in, path, values);
  return values;
}

model::RowMatrix read_matrix(const StoredFile& in, const std::string& path, Index rows, Index columns);
Eigen::VectorXd read_column(const StoredFile& in, const std::string& path, Index length = any);
/// Texts, `columns` for each row, row after row; none if there is no such dataset.
std::vector<std::string> read_texts(const StoredFile& in, const std::string& path, Index columns = 1);

}  // namespace ritz::format
