// Writes groups, attributes and datasets. Every function is *Collective* and throws std::runtime_error on all ranks
// when one of them fails.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hdf5.hpp"
#include "ritz/format/parts.hpp"

namespace ritz::format {

/// Creates the group and its missing parents. Links keep the order in which they are made.
void create_group(const ModelWriter& out, const std::string& path);

/// The link names of the bodies of which something has been written, in that order.
std::vector<std::string> body_links(const ModelWriter& out);
/// The group into which is written what a file with a single body has at its root: the root for the first body, the
/// body's own group for every other body. A body of which nothing has been written is created by this.
std::string home(const ModelWriter& out, std::string_view body);

void write_attribute(const ModelWriter& out, const std::string& object, const char* name, double value);
void write_attribute(const ModelWriter& out, const std::string& object, const char* name, std::int64_t value);
void write_attribute(const ModelWriter& out, const std::string& object, const char* name, std::uint64_t value);
void write_attribute(const ModelWriter& out, const std::string& object, const char* name,
                     std::span<const std::int64_t> values);
void write_attribute(const ModelWriter& out, const std::string& object, const char* name, std::string_view text);
/// Makes the file one of another version of the format.
void raise_version(const ModelWriter& out, const schema::Version& version);
/// Writes a fixed-length ASCII string, as VTKHDF requires.
void write_ascii(const ModelWriter& out, const std::string& object, const char* name, std::string_view text);

/// This rank's rows of a dataset.
struct Block {
  const void* data;
  Index rows;
  Slice slice;
  std::vector<hsize_t> row_shape;  ///< empty: a row is one number
  hid_t type;
};

/// Creates the dataset, writes the block of each rank, and adds units and checksum.
void write_block(const ModelWriter& out, const std::string& path, std::string_view units, const Block& block);

/// Each rank passes its own rows, of `row_length` numbers each; 0: the dataset has one dimension.
template <class T>
void write_rows(const ModelWriter& out, const std::string& path, std::string_view units, std::span<const T> values,
                Slice slice, hsize_t row_length = 0) {
  std::vector<hsize_t> row_shape(row_length > 0 ? 1 : 0, row_length);
  const auto rows = static_cast<Index>(values.size() / (row_length > 0 ? row_length : 1));
  write_block(out, path, units, {values.data(), rows, slice, std::move(row_shape), hdf5_type<T>()});
}

/// Writes a replicated list; one rank writes it.
template <class T>
void write_vector(const ModelWriter& out, const std::string& path, std::string_view units, std::span<const T> values) {
  const auto mine = out.access().writes_small ? values : std::span<const T>();
  write_rows<T>(out, path, units, mine, {0, static_cast<Index>(values.size())});
}
inline std::span<const double> view(const Eigen::VectorXd& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }
/// Writes a replicated matrix, row-major, with the same shape in the file.
void write_matrix(const ModelWriter& out, const std::string& path, std::string_view units, const model::RowMatrix& m);

/// Writes replicated texts, `columns` for each row (1: a plain list), all of one fixed length, padded with zeros.
/// Writes nothing if there are none.
void write_texts(const ModelWriter& out, const std::string& path, const std::vector<std::string>& texts,
                 std::size_t columns = 1);

}  // namespace ritz::format
