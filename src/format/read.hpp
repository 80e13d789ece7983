// Groups, attributes and datasets being read. Everything that is not as expected is an InputError that names the file
// and the path in it.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hdf5.hpp"
#include "ritz/format/parts.hpp"

namespace ritz::format {

/// "FILE: PATH WHAT; write the model again".
[[noreturn]] void fail(const ModelReader& in, const std::string& path, const std::string& what);

bool exists(const ModelReader& in, const std::string& path);
/// Names of a group's links in the order they were made; none when there is no such group.
std::vector<std::string> links(const ModelReader& in, const std::string& group);

double read_double(const ModelReader& in, const std::string& object, const char* name);
Index read_index(const ModelReader& in, const std::string& object, const char* name);
std::uint64_t read_bits(const ModelReader& in, const std::string& object, const char* name);
std::vector<Index> read_indices(const ModelReader& in, const std::string& object, const char* name);
std::string read_text(const ModelReader& in, const std::string& object, const char* name);

using Shape = std::vector<Index>;
inline constexpr Index any = -1;  ///< in an expected shape: any length

/// A dataset open for reading: numbers or fixed-length texts, in one or more dimensions.
class StoredArray {
 public:
  StoredArray(const ModelReader& in, std::string path);

  const Shape& shape() const { return shape_; }
  Index rows() const { return shape_.front(); }
  std::size_t row_bytes() const;
  hid_t type() const { return type_.get(); }
  hid_t dataset() const { return dataset_.get(); }

  /// Throws unless the shape is `expected` and, where one is given, the type is `type`.
  void expect(const Shape& expected, hid_t type) const;
  /// Reads rows [first, first + count) as they are stored, and verifies the checksum when those are all rows.
  void read(Index first, Index count, void* data) const;

 private:
  const ModelReader& in_;
  std::string path_;
  Dataset dataset_;
  Type type_;
  Shape shape_;
};

template <class T>
std::vector<T> read_vector(const ModelReader& in, const std::string& path, Index length = any) {
  const StoredArray array(in, path);
  array.expect({length}, hdf5_type<T>());
  std::vector<T> values(static_cast<std::size_t>(array.rows()));
  array.read(0, array.rows(), values.data());
  return values;
}

model::RowMatrix read_matrix(const ModelReader& in, const std::string& path, Index rows, Index columns);
Eigen::VectorXd read_column(const ModelReader& in, const std::string& path, Index length = any);
/// `columns` texts a row, row after row; none when there is no such dataset.
std::vector<std::string> read_texts(const ModelReader& in, const std::string& path, Index columns = 1);

}  // namespace ritz::format
