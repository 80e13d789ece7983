// Groups, attributes and datasets being read. Everything that is not as expected is an InputError that names the file
// and the path in it.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hdf5.hpp"
#include "ritz/format/parts.hpp"
#include "ritz/format/stored_file.hpp"

namespace ritz::format {

/// "FILE: PATH WHAT; write the model again".
[[noreturn]] void fail(const StoredFile& in, const std::string& path, const std::string& what);
/// "FILE: PATH: SENTENCE; write the model again", unless `holds`.
void require(bool holds, const StoredFile& in, const std::string& path, const std::string& sentence);

/// Names of a group's links in the order they were made; none when there is no such group. Throws InputError where one
/// of them is not a hard link.
std::vector<std::string> links(const StoredFile& in, const std::string& group);

/// Where what a file of one body keeps at its root stands for body `body`: the root for the first body, the body's own
/// group for each other one.
std::string home(const ModelReader& in, std::string_view body);

std::vector<Index> read_indices(const StoredFile& in, const std::string& object, const char* name);

/// The shape of a dataset, of one dimension at least. Throws InputError for what survey() does not let pass, and for
/// a view.
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

  /// Throws unless the shape is `expected` and, where one is given, the type is `type`.
  void expect(const Shape& expected, hid_t type) const;
  /// Reads rows [first, first + count) as they are stored.
  void load(Index first, Index count, void* data) const;
  /// The same, and verifies the checksum when those are all rows.
  void read(Index first, Index count, void* data) const;

 private:
  const StoredFile& in_;
  std::string path_;
  Shape shape_;
  Dataset dataset_;
  Type type_;
};

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
/// `columns` texts a row, row after row; none when there is no such dataset.
std::vector<std::string> read_texts(const StoredFile& in, const std::string& path, Index columns = 1);

}  // namespace ritz::format
