// HDF5's types, and its error messages.
#pragma once
#include <hdf5.h>

#include <cstdint>
#include <type_traits>

namespace ritz::format {

/// Switches off HDF5's own printing of errors for the lifetime of the object; ritz reports errors as exceptions of one
/// sentence.
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

/// The errno behind HDF5's last failure; 0 if HDF5 does not know it.
int hdf5_error();

/// The HDF5 type of T in the file and (on little-endian machines, the only ones supported) in memory. HDF5 owns it.
template <class T>
hid_t hdf5_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_IEEE_F64LE;
  else if constexpr (std::is_same_v<T, float>) return H5T_IEEE_F32LE;
  else if constexpr (std::is_same_v<T, std::int64_t>) return H5T_STD_I64LE;
  else if constexpr (std::is_same_v<T, std::uint64_t>) return H5T_STD_U64LE;
  else {
    static_assert(std::is_same_v<T, std::uint8_t>);
    return H5T_STD_U8LE;
  }
}

}  // namespace ritz::format
