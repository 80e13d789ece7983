#include "motion_dataset.hpp"

#include <stdexcept>

namespace ritz::tools {
namespace {

format::Space simple(const Shape& shape) {
  return format::Space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
}

format::Dataset create(hid_t file, const char* name, hid_t type, const Shape& shape, const std::string& units) {
  const format::Space space = simple(shape);
  const format::Properties unfilled(H5Pcreate(H5P_DATASET_CREATE));
  require_written(H5Pset_fill_time(unfilled.get(), H5D_FILL_TIME_NEVER) >= 0);
  format::Dataset dataset(H5Dcreate2(file, name, type, space.get(), H5P_DEFAULT, unfilled.get(), H5P_DEFAULT));
  require_written(static_cast<bool>(dataset));
  write_attribute(dataset.get(), "units", units);
  return dataset;
}

}  // namespace

void require_written(bool good) {
  if (!good) throw std::runtime_error("could not write all of the motion: is the disk full?");
}

void write_attribute(hid_t object, const char* name, const std::string& text) {
  const format::Type type(H5Tcopy(H5T_C_S1));
  require_written(H5Tset_size(type.get(), text.size()) >= 0 && H5Tset_cset(type.get(), H5T_CSET_UTF8) >= 0);
  const format::Space space(H5Screate(H5S_SCALAR));
  const format::Attribute attribute(H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT));
  require_written(attribute && H5Awrite(attribute.get(), type.get(), text.data()) >= 0);
}

format::Dataset create_floats(hid_t file, const char* name, const Shape& shape, const std::string& units) {
  return create(file, name, H5T_IEEE_F64LE, shape, units);
}

void write_integers(hid_t file, const char* name, std::span<const std::int64_t> values) {
  const format::Dataset dataset = create(file, name, H5T_STD_I64LE, {values.size()}, "1");
  require_written(H5Dwrite(dataset.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
}

void write_block(const format::Dataset& dataset, const Shape& start, const Shape& count, const double* values) {
  const format::Space in_file(H5Dget_space(dataset.get())), in_memory = simple(count);
  require_written(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >=
                      0 &&
                  H5Dwrite(dataset.get(), H5T_NATIVE_DOUBLE, in_memory.get(), in_file.get(), H5P_DEFAULT, values) >= 0);
}

void view_entry(hid_t file, const std::string& name, const char* source, const Shape& shape, hsize_t index,
                const std::string& units) {
  Shape start(shape.size(), 0), count = shape;
  start[0] = index;
  count[0] = 1;
  const format::Space entry = simple(Shape(shape.begin() + 1, shape.end())), all = simple(shape);
  const format::Properties view(H5Pcreate(H5P_DATASET_CREATE)), parents(H5Pcreate(H5P_LINK_CREATE));
  require_written(H5Sselect_hyperslab(all.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >= 0 &&
                  H5Pset_virtual(view.get(), entry.get(), ".", source, all.get()) >= 0 &&
                  H5Pset_create_intermediate_group(parents.get(), 1) >= 0);
  const format::Dataset dataset(
      H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, entry.get(), parents.get(), view.get(), H5P_DEFAULT));
  require_written(static_cast<bool>(dataset));
  write_attribute(dataset.get(), "units", units);
}

}  // namespace ritz::tools
