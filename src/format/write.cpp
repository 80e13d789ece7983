#include "write.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "collective.hpp"
#include "ritz/format/checksum.hpp"

namespace ritz::format {

namespace {

/// No time stamps: the same model gives the same bytes.
Properties creation(hid_t kind) {
  Properties properties(H5Pcreate(kind));
  H5Pset_obj_track_times(properties.get(), false);
  return properties;
}

void put_attribute(const ModelWriter& out, const std::string& object, const char* name, hid_t type, const Space& space,
                   const std::string& bytes) {
  const Attribute attribute(
      H5Acreate_by_name(out.file(), object.c_str(), name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  agree(out, attribute && H5Awrite(attribute.get(), type, bytes.data()) >= 0, object);
}

template <class T>
std::string bytes_of(const ModelWriter& out, std::span<const T> values) {
  return shared(out.access(), std::string(reinterpret_cast<const char*>(values.data()), values.size_bytes()));
}

template <class T>
void put_number(const ModelWriter& out, const std::string& object, const char* name, T value) {
  const Quiet quiet;
  put_attribute(out, object, name, hdf5_type<T>(), Space(H5Screate(H5S_SCALAR)),
                bytes_of(out, std::span<const T>(&value, 1)));
}

/// `width` bytes, padded with zeros.
Type text_type(std::size_t width, H5T_cset_t encoding) {
  Type type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.get(), width);
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  H5Tset_cset(type.get(), encoding);
  return type;
}

void put_text(const ModelWriter& out, const std::string& object, const char* name, std::string_view text,
              H5T_cset_t encoding) {
  const Quiet quiet;
  auto bytes = shared(out.access(), std::string(text));
  bytes.resize(std::max<std::size_t>(bytes.size(), 1));
  put_attribute(out, object, name, text_type(bytes.size(), encoding).get(), Space(H5Screate(H5S_SCALAR)), bytes);
}

Space space_of(Index rows, const std::vector<hsize_t>& row_shape) {
  std::vector<hsize_t> dims(1, static_cast<hsize_t>(rows));
  dims.insert(dims.end(), row_shape.begin(), row_shape.end());
  return Space(H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr));
}

/// Selects this rank's rows; an empty block selects nothing but still takes part.
void select(const Space& file, const Space& memory, const Block& block) {
  if (block.rows == 0) {
    H5Sselect_none(file.get());
    H5Sselect_none(memory.get());
    return;
  }
  std::vector<hsize_t> start(1 + block.row_shape.size(), 0), count(1, static_cast<hsize_t>(block.rows));
  start[0] = static_cast<hsize_t>(block.slice.first);
  count.insert(count.end(), block.row_shape.begin(), block.row_shape.end());
  H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
}

/// Every row must be written by one rank: a gap would be garbage with a good checksum, and a rank that stops before
/// HDF5's collective write would leave the others waiting in it.
void check_cover(const ModelWriter& out, const std::string& path, const Block& block) {
  const auto& [first, total] = block.slice;
  const bool inside = block.rows >= 0 && first >= 0 && first + block.rows <= total;
  const auto outside = sum(out.access(), inside ? 0 : 1);
  const auto rows = sum(out.access(), static_cast<std::uint64_t>(block.rows));
  if (outside > 0 || rows != static_cast<std::uint64_t>(total))
    throw std::logic_error("the ranks' rows of " + path + " do not make up the whole");
}

}  // namespace

void create_group(const ModelWriter& out, const std::string& path) {
  const Quiet quiet;
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    const auto prefix = path.substr(0, end);
    if (H5Lexists(out.file(), prefix.c_str(), H5P_DEFAULT) <= 0) {
      const auto properties = creation(H5P_GROUP_CREATE);
      H5Pset_link_creation_order(properties.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
      const Group group(H5Gcreate2(out.file(), prefix.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT));
      agree(out, bool(group), prefix);
    }
    if (end == std::string::npos) return;
  }
}

std::vector<std::string> body_links(const ModelWriter& out) {
  const Quiet quiet;
  const std::string bodies(schema::bodies);
  std::vector<std::string> names;
  H5G_info_t info{};
  if (H5Lexists(out.file(), bodies.c_str(), H5P_DEFAULT) <= 0 ||
      H5Gget_info_by_name(out.file(), bodies.c_str(), &info, H5P_DEFAULT) < 0)
    return names;
  const auto name = [&](hsize_t i, char* text, std::size_t size) {
    return H5Lget_name_by_idx(out.file(), bodies.c_str(), H5_INDEX_CRT_ORDER, H5_ITER_INC, i, text, size, H5P_DEFAULT);
  };
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    names.emplace_back(static_cast<std::size_t>(std::max<ssize_t>(name(i, nullptr, 0), 0)), '\0');
    name(i, names.back().data(), names.back().size() + 1);
  }
  return names;
}

std::string home(const ModelWriter& out, std::string_view body) {
  create_group(out, schema::body_group(body));
  return body_links(out).front() == schema::link_name(body) ? std::string() : schema::body_group(body);
}

void write_attribute(const ModelWriter& out, const std::string& object, const char* name, double value) {
  put_number(out, object, name, value);
}

void write_attribute(const ModelWriter& out, const std::string& object, const char* name, std::int64_t value) {
  put_number(out, object, name, value);
}

void write_attribute(const ModelWriter& out, const std::string& object, const char* name, std::uint64_t value) {
  put_number(out, object, name, value);
}

void write_attribute(const ModelWriter& out, const std::string& object, const char* name,
                     std::span<const std::int64_t> values) {
  const Quiet quiet;
  put_attribute(out, object, name, hdf5_type<std::int64_t>(), space_of(static_cast<Index>(values.size()), {}),
                bytes_of(out, values));
}

void raise_version(const ModelWriter& out, const schema::Version& version) {
  const Quiet quiet;
  const std::array<std::int64_t, 2> values = {version.major, version.minor};
  const Attribute attribute(H5Aopen(out.file(), schema::version, H5P_DEFAULT));
  agree(out, attribute && H5Awrite(attribute.get(), hdf5_type<std::int64_t>(), values.data()) >= 0, "/");
}

void write_attribute(const ModelWriter& out, const std::string& object, const char* name, std::string_view text) {
  put_text(out, object, name, text, H5T_CSET_UTF8);
}

void write_ascii(const ModelWriter& out, const std::string& object, const char* name, std::string_view text) {
  put_text(out, object, name, text, H5T_CSET_ASCII);
}

void write_block(const ModelWriter& out, const std::string& path, std::string_view units, const Block& block) {
  const Quiet quiet;
  check_cover(out, path, block);
  std::size_t row_bytes = H5Tget_size(block.type);
  for (const auto length : block.row_shape) row_bytes *= length;
  out.make_room(static_cast<std::uint64_t>(block.slice.total) * row_bytes);
  const auto properties = creation(H5P_DATASET_CREATE);
  H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY);
  H5Pset_fill_time(properties.get(), H5D_FILL_TIME_NEVER);
  const auto file = space_of(block.slice.total, block.row_shape);
  const auto memory = space_of(block.rows, block.row_shape);
  const Dataset dataset(
      H5Dcreate2(out.file(), path.c_str(), block.type, file.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT));
  agree(out, bool(dataset), path);

  select(file, memory, block);
  const bool written =  // an empty dataset cannot be written collectively
      block.slice.total == 0 ||
      H5Dwrite(dataset.get(), block.type, memory.get(), file.get(), out.access().transfer, block.data) >= 0;
  agree(out, written, path);

  const std::span bytes(static_cast<const std::byte*>(block.data), static_cast<std::size_t>(block.rows) * row_bytes);
  write_attribute(out, path, schema::units, units);
  write_attribute(out, path, schema::checksum, sum(out.access(), checksum(bytes, row_bytes, block.slice.first)));
}

void write_matrix(const ModelWriter& out, const std::string& path, std::string_view units, const model::RowMatrix& m) {
  const auto mine = out.access().writes_small ? m.rows() : 0;
  const auto columns = static_cast<hsize_t>(m.cols());
  write_block(out, path, units, {m.data(), mine, {0, m.rows()}, {columns}, hdf5_type<double>()});
}

void write_texts(const ModelWriter& out, const std::string& path, const std::vector<std::string>& texts,
                 std::size_t columns) {
  std::size_t width = 1;
  for (const auto& text : texts) width = std::max(width, text.size());
  width = shared(out.access(), width);
  const auto rows = static_cast<Index>(shared(out.access(), texts.size() / columns));
  if (rows == 0) return;

  std::string bytes;
  if (out.access().writes_small)
    for (const auto& text : texts) bytes.append(text).append(width - text.size(), '\0');
  std::vector<hsize_t> row_shape(columns > 1 ? 1 : 0, columns);
  const auto type = text_type(width, H5T_CSET_UTF8);
  write_block(out, path, "1", {bytes.data(), bytes.empty() ? 0 : rows, {0, rows}, std::move(row_shape), type.get()});
}

}  // namespace ritz::format
