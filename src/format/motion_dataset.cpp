#include "ritz/format/motion_dataset.hpp"

#include "hdf5.hpp"
#include "ritz/files/failure.hpp"

namespace ritz::format {
namespace {

Space simple(const Extent& shape) {
  return Space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
}

Dataset create(hid_t file, const char* name, hid_t type, const Extent& shape, const std::string& units) {
  const Space space = simple(shape);
  const Properties unfilled(H5Pcreate(H5P_DATASET_CREATE));
  require_written(H5Pset_fill_time(unfilled.get(), H5D_FILL_TIME_NEVER) >= 0);
  Dataset dataset(H5Dcreate2(file, name, type, space.get(), H5P_DEFAULT, unfilled.get(), H5P_DEFAULT));
  require_written(static_cast<bool>(dataset));
  write_attribute(dataset.get(), "units", units);
  return dataset;
}

/// One number of the type that it has in the file, on a little-endian machine.
void write_number(hid_t object, const char* name, hid_t type, const void* value) {
  const Space space(H5Screate(H5S_SCALAR));
  const Attribute attribute(H5Acreate2(object, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT));
  require_written(attribute && H5Awrite(attribute.get(), type, value) >= 0);
}

}  // namespace

void require_written(bool good) {
  if (!good) files::fail_to_write("all of the motion", hdf5_error());
}

void write_attribute(hid_t object, const char* name, const std::string& text) {
  const Type type(H5Tcopy(H5T_C_S1));
  require_written(H5Tset_size(type.get(), text.size()) >= 0 && H5Tset_cset(type.get(), H5T_CSET_UTF8) >= 0);
  const Space space(H5Screate(H5S_SCALAR));
  const Attribute attribute(H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT));
  require_written(attribute && H5Awrite(attribute.get(), type.get(), text.data()) >= 0);
}

void write_attribute(hid_t object, const char* name, double value) {
  write_number(object, name, H5T_IEEE_F64LE, &value);
}

void write_attribute(hid_t object, const char* name, std::uint64_t value) {
  write_number(object, name, H5T_STD_U64LE, &value);
}

Dataset create_floats(hid_t file, const char* name, const Extent& shape, const std::string& units) {
  return create(file, name, H5T_IEEE_F64LE, shape, units);
}

void write_integers(hid_t file, const char* name, std::span<const std::int64_t> values) {
  const Dataset dataset = create(file, name, H5T_STD_I64LE, {values.size()}, "1");
  require_written(H5Dwrite(dataset.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
}

void write_block(const Dataset& dataset, const Extent& start, const Extent& count, const double* values) {
  const Space in_file(H5Dget_space(dataset.get())), in_memory = simple(count);
  require_written(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >=
                      0 &&
                  H5Dwrite(dataset.get(), H5T_NATIVE_DOUBLE, in_memory.get(), in_file.get(), H5P_DEFAULT, values) >= 0);
}

void view_part(hid_t file, const std::string& name, const Extent& shape, const View& part, const std::string& units) {
  const Space shown = simple(shape), all = simple(part.dimensions);
  const Properties view(H5Pcreate(H5P_DATASET_CREATE)), parents(H5Pcreate(H5P_LINK_CREATE));
  require_written(
      H5Sselect_hyperslab(all.get(), H5S_SELECT_SET, part.start.data(), nullptr, part.count.data(), nullptr) >= 0 &&
      H5Pset_virtual(view.get(), shown.get(), ".", part.source, all.get()) >= 0 &&
      H5Pset_create_intermediate_group(parents.get(), 1) >= 0);
  const Dataset dataset(
      H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, shown.get(), parents.get(), view.get(), H5P_DEFAULT));
  require_written(static_cast<bool>(dataset));
  write_attribute(dataset.get(), "units", units);
}

void view_entry(hid_t file, const std::string& name, const char* source, const Extent& shape, hsize_t index,
                const std::string& units) {
  View entry{source, shape, Extent(shape.size(), 0), shape};
  entry.start[0] = index;
  entry.count[0] = 1;
  view_part(file, name, Extent(shape.begin() + 1, shape.end()), entry, units);
}

}  // namespace ritz::format
