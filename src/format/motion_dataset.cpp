#include "motion_dataset.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "hdf5.hpp"
#include "ritz/files/part_file.hpp"
#include "ritz/format/checksum.hpp"
#include "ritz/format/schema.hpp"

namespace ritz::format {
namespace {

Space simple(const Extent& shape) {
  return Space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
}

hsize_t row_length(const Extent& shape) {
  return std::accumulate(shape.begin() + 1, shape.end(), hsize_t{1}, std::multiplies{});
}

}  // namespace

void require_written(bool good) {
  if (!good) files::fail_to_write("all of the motion", hdf5_error());
}

void attach(hid_t object, const char* name, hid_t type, const void* value) {
  const Space space(H5Screate(H5S_SCALAR));
  const Attribute attribute(H5Acreate2(object, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT));
  require_written(attribute && H5Awrite(attribute.get(), type, value) >= 0);
}

void attach_text(hid_t object, const char* name, std::string_view text) {
  const Type type(H5Tcopy(H5T_C_S1));
  require_written(H5Tset_size(type.get(), text.size()) >= 0 && H5Tset_cset(type.get(), H5T_CSET_UTF8) >= 0);
  attach(object, name, type.get(), text.data());
}

hid_t type_of(Stored stored) { return stored == Stored::float32 ? H5T_IEEE_F32LE : H5T_IEEE_F64LE; }

Dataset create(hid_t file, const std::string& name, hid_t type, const Extent& shape, const std::string& units) {
  const Space space = simple(shape);
  const Properties unfilled(H5Pcreate(H5P_DATASET_CREATE));
  require_written(H5Pset_fill_time(unfilled.get(), H5D_FILL_TIME_NEVER) >= 0);
  Dataset dataset(H5Dcreate2(file, name.c_str(), type, space.get(), H5P_DEFAULT, unfilled.get(), H5P_DEFAULT));
  require_written(static_cast<bool>(dataset));
  attach_text(dataset.get(), schema::units, units);
  return dataset;
}

void write_integers(hid_t file, const char* name, std::span<const std::int64_t> values) {
  const Dataset dataset = create(file, name, H5T_STD_I64LE, {values.size()}, "1");
  require_written(H5Dwrite(dataset.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
}

void write_numbers(hid_t file, const char* name, std::span<const double> values, const std::string& units) {
  NumberStream stream(file, name, {values.size()}, units);
  stream.append(values);
  stream.close();
}

void show(hid_t file, const std::string& name, const Extent& shape, const Rows& rows) {
  Extent start(rows.all.size(), 0), count = rows.all;
  start[0] = rows.first;
  count[0] = rows.count;
  const Space shown = simple(shape), all = simple(rows.all);
  const Properties view(H5Pcreate(H5P_DATASET_CREATE)), parents(H5Pcreate(H5P_LINK_CREATE));
  require_written(H5Sselect_hyperslab(all.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >= 0 &&
                  H5Pset_virtual(view.get(), shown.get(), ".", rows.source.c_str(), all.get()) >= 0 &&
                  H5Pset_create_intermediate_group(parents.get(), 1) >= 0);
  const Dataset dataset(
      H5Dcreate2(file, name.c_str(), type_of(rows.stored), shown.get(), parents.get(), view.get(), H5P_DEFAULT));
  require_written(static_cast<bool>(dataset));
  attach_text(dataset.get(), schema::units, "m");
}

NumberStream::NumberStream(hid_t file, const std::string& name, Extent shape, const std::string& units, Checked checked,
                           Stored stored)
    : dataset_(create(file, name, type_of(stored), shape, units)),
      shape_(std::move(shape)),
      checked_(checked),
      stored_(stored) {}

void NumberStream::append(std::span<const double> piece) {
  constexpr std::size_t most = 4096;
  if (pending_.empty() && piece.size() >= most) return write(piece);
  pending_.insert(pending_.end(), piece.begin(), piece.end());
  if (pending_.size() < most) return;
  write(pending_);
  pending_.clear();
}

hsize_t NumberStream::checked_row() const { return checked_ == Checked::by_vertex ? 3 : row_length(shape_); }

void NumberStream::write(std::span<const double> piece) {
  const Space in_file(H5Dget_space(dataset_.get()));
  const hsize_t row = row_length(shape_);
  if (checked_ != Checked::no && !piece.empty())
    sum_ += checksum(std::as_bytes(piece), checked_row() * sizeof(double),
                     static_cast<std::int64_t>(written_ / checked_row()));
  while (!piece.empty()) {
    Extent start(shape_.size(), 0), count = shape_;
    const hsize_t within = written_ % row, whole = within == 0 ? piece.size() / row : 0;
    start[0] = written_ / row;
    count[0] = std::max<hsize_t>(whole, 1);
    if (whole == 0) start[1] = within, count[1] = std::min<hsize_t>(piece.size(), row - within);
    const Space in_memory = simple(count);
    require_written(
        H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >= 0 &&
        H5Dwrite(dataset_.get(), H5T_NATIVE_DOUBLE, in_memory.get(), in_file.get(), H5P_DEFAULT, piece.data()) >= 0);
    const hsize_t numbers = count[0] * row_length(count);
    piece = piece.subspan(numbers);
    written_ += numbers;
  }
}

void NumberStream::close() {
  if (!dataset_) return;
  write(pending_);
  pending_.clear();
  if (checked_ != Checked::no) attach(dataset_.get(), schema::checksum, H5T_STD_U64LE, &sum_);
  require_written(dataset_.close());
}

}  // namespace ritz::format
