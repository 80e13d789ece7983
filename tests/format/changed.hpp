// A model that is changed behind the writer's back, with checksums that are right.
#pragma once
#include <hdf5.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "format/temporary.hpp"
#include "ritz/format/checksum.hpp"
#include "ritz/format/handle.hpp"
#include "ritz/format/parts.hpp"

namespace ritz::test {

/// The model's bytes after `change` was done to it through HDF5.
inline Bytes changed(const model::Model& model, const std::function<void(hid_t)>& change) {
  const Folder folder;
  const auto path = folder / "changed.h5";
  format::write(path, model);
  {
    const format::File file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
    change(file.get());
  }
  return load(path);
}

inline void attach(hid_t dataset, const char* name, std::uint64_t value) {
  const format::Space one(H5Screate(H5S_SCALAR));
  const format::Attribute a(H5Acreate2(dataset, name, H5T_STD_U64LE, one.get(), H5P_DEFAULT, H5P_DEFAULT));
  H5Awrite(a.get(), H5T_STD_U64LE, &value);
}

inline void attach_units(hid_t dataset) {
  const format::Space one(H5Screate(H5S_SCALAR));
  const format::Attribute a(H5Acreate2(dataset, "units", H5T_C_S1, one.get(), H5P_DEFAULT, H5P_DEFAULT));
  H5Awrite(a.get(), H5T_C_S1, "1");
}

/// Puts these numbers in the place of a dataset, with units and the checksum that they have.
inline void put(hid_t file, const std::string& path, const std::vector<hsize_t>& shape,
                const std::vector<double>& numbers, hid_t creation = H5P_DEFAULT) {
  H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  const format::Space space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
  const format::Dataset made(
      H5Dcreate2(file, path.c_str(), H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, creation, H5P_DEFAULT));
  if (!numbers.empty()) H5Dwrite(made.get(), H5T_IEEE_F64LE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
  std::size_t row = sizeof(double);
  for (std::size_t d = 1; d < shape.size(); ++d) row *= shape[d];
  attach_units(made.get());
  attach(made.get(), "checksum", format::checksum(std::as_bytes(std::span(numbers)), row));
}

}  // namespace ritz::test
