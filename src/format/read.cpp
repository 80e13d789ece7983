#include "read.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "raw_header.hpp"
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

struct Link {
  bool unnumbered = false;  ///< by programs that do not keep the order
  std::int64_t order = 0;
  std::string name;
  bool hard = true;

  auto place() const { return std::tie(unnumbered, order, name); }
};

herr_t collect(hid_t, const char* name, const H5L_info_t* info, void* data) {
  const bool numbered = info->corder_valid > 0;
  static_cast<std::vector<Link>*>(data)->push_back(
      {!numbered, numbered ? info->corder : 0, name, info->type == H5L_TYPE_HARD});
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

// In the order that HDF5 finds them in, and sorted here: for an order of its own HDF5 1.10 makes a table, which it
// frees half filled where a group's heap is damaged.
std::vector<std::string> links(const StoredFile& in, const std::string& group) try {
  if (!exists(in, group)) return {};
  const Quiet quiet;
  H5O_info_t info{};
  if (H5Oget_info_by_name2(in.file(), group.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT) < 0) bad_header();
  check_links(RawFile(in.file()), info.addr);
  std::vector<Link> found;
  if (H5Literate_by_name(in.file(), group.c_str(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect, &found,
                         H5P_DEFAULT) < 0)
    fail(in, group, "is not a readable group");
  std::ranges::sort(found, {}, &Link::place);
  std::vector<std::string> names;
  for (const auto& link : found) {
    if (!link.hard) fail(in, schema::join(group == "/" ? "" : group, link.name), "is a link to elsewhere");
    names.push_back(link.name);
  }
  return names;
} catch (const BadHeader& error) {
  fail(in, group, error.what());
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
