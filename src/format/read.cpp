#include "read.hpp"

#include <algorithm>

#include "ritz/base/error.hpp"
#include "ritz/format/checksum.hpp"

namespace ritz::format {

namespace {

std::string text(const Shape& shape) {
  std::string s;
  for (const auto length : shape) s += (s.empty() ? "" : " x ") + (length == any ? "any" : std::to_string(length));
  return s;
}

Shape extent(hid_t dataset) {
  const Space space(H5Dget_space(dataset));
  std::vector<hsize_t> dims(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.get()))));
  H5Sget_simple_extent_dims(space.get(), dims.data(), nullptr);
  return {dims.begin(), dims.end()};
}

/// What a model holds: rows of numbers or of texts of one length.
bool holds_plain_values(hid_t type) {
  const auto kind = H5Tget_class(type);
  return kind == H5T_INTEGER || kind == H5T_FLOAT || (kind == H5T_STRING && H5Tis_variable_str(type) == 0);
}

herr_t collect(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

}  // namespace

void fail(const ModelReader& in, const std::string& path, const std::string& what) {
  throw InputError(in.name() + ": " + path + " " + what + "; write the model again with ritz-reduce");
}

bool exists(const ModelReader& in, const std::string& path) {
  const Quiet quiet;
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    const auto prefix = path.substr(0, end);
    const auto found = H5Lexists(in.file(), prefix.c_str(), H5P_DEFAULT);
    if (found < 0) fail(in, prefix, "cannot be looked up: the file is damaged");
    if (found == 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::vector<std::string> links(const ModelReader& in, const std::string& group) {
  std::vector<std::string> names;
  if (!exists(in, group)) return names;
  const Quiet quiet;
  hsize_t at = 0;
  if (H5Literate_by_name(in.file(), group.c_str(), H5_INDEX_CRT_ORDER, H5_ITER_INC, &at, collect, &names, H5P_DEFAULT) <
      0)
    fail(in, group, "is not a readable group");
  return names;
}

StoredArray::StoredArray(const ModelReader& in, std::string path) : in_(in), path_(std::move(path)) {
  if (!exists(in, path_)) fail(in, path_, "is missing");
  const Quiet quiet;
  dataset_ = Dataset(H5Dopen2(in.file(), path_.c_str(), H5P_DEFAULT));
  if (!dataset_) fail(in, path_, "is not a readable dataset");
  type_ = Type(H5Dget_type(dataset_.get()));
  shape_ = extent(dataset_.get());
  if (shape_.empty()) fail(in, path_, "is a single value where a list is expected");
  if (!holds_plain_values(type_.get())) fail(in, path_, "has values that are neither numbers nor fixed-length texts");
}

std::size_t StoredArray::row_bytes() const {
  std::size_t bytes = H5Tget_size(type_.get());
  for (std::size_t d = 1; d < shape_.size(); ++d) bytes *= static_cast<std::size_t>(shape_[d]);
  return bytes;
}

void StoredArray::expect(const Shape& expected, hid_t type) const {
  const Quiet quiet;
  const auto fits = [](Index have, Index want) { return want == any || have == want; };
  if (!std::ranges::equal(shape_, expected, fits))
    fail(in_, path_, "has the shape " + text(shape_) + " where " + text(expected) + " is expected");
  if (H5Tequal(type_.get(), type) <= 0) fail(in_, path_, "has the wrong type of number");
  hsize_t file_bytes = 0;
  H5Fget_filesize(in_.file(), &file_bytes);
  if (static_cast<double>(rows()) * static_cast<double>(row_bytes()) > static_cast<double>(file_bytes))
    fail(in_, path_, "claims to be larger than the file");
}

void StoredArray::read(Index first, Index count, void* data) const {
  const Quiet quiet;
  const Space file(H5Dget_space(dataset_.get()));
  std::vector<hsize_t> start(shape_.size(), 0), counts(shape_.begin(), shape_.end());
  start[0] = static_cast<hsize_t>(first);
  counts[0] = static_cast<hsize_t>(count);
  const Space memory(H5Screate_simple(static_cast<int>(counts.size()), counts.data(), nullptr));
  const bool done =
      count == 0 ||
      (H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, start.data(), nullptr, counts.data(), nullptr) >= 0 &&
       H5Dread(dataset_.get(), type_.get(), memory.get(), file.get(), H5P_DEFAULT, data) >= 0);
  if (!done) fail(in_, path_, "cannot be read");
  if (count != rows()) return;
  const std::span bytes(static_cast<const std::byte*>(data), static_cast<std::size_t>(count) * row_bytes());
  if (checksum(bytes, row_bytes()) != read_bits(in_, path_, schema::checksum))
    fail(in_, path_, "does not have the checksum it was written with: the file is damaged");
}

model::RowMatrix read_matrix(const ModelReader& in, const std::string& path, Index rows, Index columns) {
  const StoredArray array(in, path);
  array.expect({rows, columns}, hdf5_type<double>());
  model::RowMatrix m(array.shape()[0], array.shape()[1]);
  array.read(0, array.rows(), m.data());
  return m;
}

Eigen::VectorXd read_column(const ModelReader& in, const std::string& path, Index length) {
  const auto values = read_vector<double>(in, path, length);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::vector<std::string> read_texts(const ModelReader& in, const std::string& path, Index columns) {
  if (!exists(in, path)) return {};
  const StoredArray array(in, path);
  if (H5Tget_class(array.type()) != H5T_STRING) fail(in, path, "is not a table of fixed-length texts");
  array.expect(columns == 1 ? Shape{any} : Shape{any, columns}, array.type());
  const auto width = H5Tget_size(array.type());
  std::string bytes(static_cast<std::size_t>(array.rows()) * array.row_bytes(), '\0');
  array.read(0, array.rows(), bytes.data());

  std::vector<std::string> texts;
  for (std::size_t at = 0; at < bytes.size(); at += width) {
    const auto cell = bytes.substr(at, width);
    texts.push_back(cell.substr(0, cell.find('\0')));
  }
  return texts;
}

}  // namespace ritz::format
