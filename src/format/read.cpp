#include "read.hpp"

#include <algorithm>
#include <cmath>

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

struct Links {
  std::vector<std::string> names;
  std::string elsewhere;  ///< one that is not a hard link
};

herr_t collect(hid_t, const char* name, const H5L_info_t* info, void* data) {
  auto& links = *static_cast<Links*>(data);
  links.names.emplace_back(name);
  if (info->type != H5L_TYPE_HARD) links.elsewhere = name;
  return 0;
}

}  // namespace

void fail(const StoredFile& in, const std::string& path, const std::string& what) {
  throw InputError(in.name() + ": " + path + " " + what + "; write the " + in.wording().kind + " again with " +
                   in.wording().writer);
}

void require(bool holds, const StoredFile& in, const std::string& path, const std::string& sentence) {
  if (!holds)
    throw InputError(in.name() + ": " + path + ": " + sentence + "; write the " + in.wording().kind + " again with " +
                     in.wording().writer);
}

void require_finite(const StoredFile& in, const std::string& path, std::span<const double> values) {
  const auto finite = [](double x) { return std::isfinite(x); };
  if (const auto bad = std::ranges::find_if_not(values, finite); bad != values.end())
    fail(in, path, "holds a number that is not a finite number, entry " + std::to_string(bad - values.begin() + 1));
}

bool exists(const StoredFile& in, const std::string& path) {
  const Quiet quiet;
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    const auto prefix = path.substr(0, end);
    const auto found = H5Lexists(in.file(), prefix.c_str(), H5P_DEFAULT);
    if (found < 0) fail(in, prefix, "cannot be looked up: the file is damaged");
    if (found == 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::vector<std::string> links(const StoredFile& in, const std::string& group) {
  Links found;
  if (!exists(in, group)) return {};
  const Quiet quiet;
  const auto iterate = [&](H5_index_t index) {
    hsize_t at = 0;
    found = {};
    return H5Literate_by_name(in.file(), group.c_str(), index, H5_ITER_INC, &at, collect, &found, H5P_DEFAULT) >= 0;
  };
  if (!iterate(H5_INDEX_CRT_ORDER) && !iterate(H5_INDEX_NAME)) fail(in, group, "is not a readable group");
  if (!found.elsewhere.empty())
    fail(in, schema::join(group == "/" ? "" : group, found.elsewhere), "is a link to elsewhere");
  return found.names;
}

std::string home(const ModelReader& in, std::string_view body) {
  return in.first_body() == body ? std::string() : schema::body_group(body);
}

StoredArray::StoredArray(const StoredFile& in, std::string path)
    : in_(in), path_(std::move(path)), shape_(stored_shape(in_, path_)) {
  const Quiet quiet;
  dataset_ = Dataset(H5Dopen2(in.file(), path_.c_str(), H5P_DEFAULT));
  if (!dataset_ || extent(dataset_.get()) != shape_) fail(in, path_, "is not a readable dataset");
  type_ = Type(H5Dget_type(dataset_.get()));
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
}

void StoredArray::load(Index first, Index count, void* data) const {
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
}

void StoredArray::read(Index first, Index count, void* data) const {
  load(first, count, data);
  if (count != rows()) return;
  const std::span bytes(static_cast<const std::byte*>(data), static_cast<std::size_t>(count) * row_bytes());
  if (checksum(bytes, row_bytes()) != read_bits(in_, path_, schema::checksum))
    fail(in_, path_, "does not have the checksum it was written with: the file is damaged");
}

model::RowMatrix read_matrix(const StoredFile& in, const std::string& path, Index rows, Index columns) {
  const StoredArray array(in, path);
  array.expect({rows, columns}, hdf5_type<double>());
  model::RowMatrix m(array.shape()[0], array.shape()[1]);
  array.read(0, array.rows(), m.data());
  require_finite(in, path, {m.data(), static_cast<std::size_t>(m.size())});
  return m;
}

Eigen::VectorXd read_column(const StoredFile& in, const std::string& path, Index length) {
  const auto values = read_vector<double>(in, path, length);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::vector<std::string> read_texts(const StoredFile& in, const std::string& path, Index columns) {
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
