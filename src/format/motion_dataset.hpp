// Functions that write parts of a motion file. All throw as files::fail_to_write does when the disk does not take what
// is written.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "ritz/format/motion.hpp"

namespace ritz::format {

using Extent = NumberStream::Extent;

/// Unless `good`, throws what the disk answered to HDF5's last call, as files::fail_to_write does.
void require_written(bool good);

/// Adds an attribute of one value, whose type is the same in memory and, on a little-endian machine, in the file.
void attach(hid_t object, const char* name, hid_t type, const void* value);
void attach_text(hid_t object, const char* name, std::string_view text);

/// Creates a dataset with the attribute "units".
Dataset create(hid_t file, const std::string& name, hid_t type, const Extent& shape, const std::string& units);
/// Create datasets and write them whole; integers have the units "1".
void write_integers(hid_t file, const char* name, std::span<const std::int64_t> values);
void write_numbers(hid_t file, const char* name, std::span<const double> values, const std::string& units);

/// Rows [first, first + count) of the dataset `source` of the same file, whose dimensions are `all`.
struct Rows {
  std::string source;
  Extent all;
  hsize_t first, count;
  Stored stored;
};

/// The type of a dataset's numbers.
hid_t type_of(Stored stored);

/// Creates a virtual dataset of dimensions `shape` that shows these rows of another dataset, without a copy; units "m".
void show(hid_t file, const std::string& name, const Extent& shape, const Rows& rows);

}  // namespace ritz::format
