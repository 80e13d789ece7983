// HDF5's types for ours, and silence.
#pragma once
#include <hdf5.h>

#include <cstdint>
#include <type_traits>

namespace ritz::format {

/// Switches off HDF5's own printing of errors while it lives: we say in one sentence what went wrong.
class Quiet {
 public:
  Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// The errno of the operating system behind HDF5's last failure; 0 where HDF5 knows none.
int hdf5_error();

/// The type in the file (and, little-endian machines only, in memory). HDF5 owns it.
template <class T>
hid_t hdf5_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_IEEE_F64LE;
  else if constexpr (std::is_same_v<T, std::int64_t>) return H5T_STD_I64LE;
  else if constexpr (std::is_same_v<T, std::uint64_t>) return H5T_STD_U64LE;
  else {
    static_assert(std::is_same_v<T, std::uint8_t>);
    return H5T_STD_U8LE;
  }
}

}  // namespace ritz::format
