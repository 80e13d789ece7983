// The few verbs that writing a motion takes. All throw NumericalError when the disk does not take what is written.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "ritz/format/motion.hpp"

namespace ritz::format {

using Extent = NumberStream::Extent;

/// Throws NumericalError that says what the disk answered to HDF5's last call, unless that was good.
void require_written(bool good);

/// An attribute of one value of a type that is the same in memory and, on a little-endian machine, in the file.
void attach(hid_t object, const char* name, hid_t type, const void* value);
void attach_text(hid_t object, const char* name, std::string_view text);

/// A new dataset with the attribute "units".
Dataset create(hid_t file, const std::string& name, hid_t type, const Extent& shape, const std::string& units);
/// New datasets that are written whole; integers have the units "1".
void write_integers(hid_t file, const char* name, std::span<const std::int64_t> values);
void write_numbers(hid_t file, const char* name, std::span<const double> values, const std::string& units);

/// Rows of the dataset `source` of the same file, of dimensions `all`.
struct Rows {
  std::string source;
  Extent all;
  hsize_t first, count;
};

/// A new dataset of dimensions `shape` that shows as many numbers of another: a view, no copy; units "m".
void show(hid_t file, const std::string& name, const Extent& shape, const Rows& rows);

}  // namespace ritz::format
