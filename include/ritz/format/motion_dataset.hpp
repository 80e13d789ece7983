// The few verbs of HDF5 that writing a motion takes.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ritz/format/handle.hpp"

namespace ritz::format {

using Extent = std::vector<hsize_t>;

/// Throws NumericalError that says what the disk answered to HDF5's last call, unless that was good.
void require_written(bool good);

void write_attribute(hid_t object, const char* name, const std::string& text);
void write_attribute(hid_t object, const char* name, double value);
void write_attribute(hid_t object, const char* name, std::uint64_t value);

/// A new dataset of 64-bit floats with the attribute "units".
Dataset create_floats(hid_t file, const char* name, const Extent& shape, const std::string& units);
/// A new dataset that is written whole; units "1".
void write_integers(hid_t file, const char* name, std::span<const std::int64_t> values);
/// Writes `count` numbers along each dimension from `start` on.
void write_block(const Dataset& dataset, const Extent& start, const Extent& count, const double* values);
/// Part of a dataset: `count` numbers along each dimension from `start` on.
struct View {
  const char* source;  ///< a dataset of the same file
  Extent dimensions;   ///< all of it
  Extent start, count;
};

/// A dataset `name` of dimensions `shape`, which shows as many numbers of another: a view, no copy.
void view_part(hid_t file, const std::string& name, const Extent& shape, const View& part, const std::string& units);

/// A dataset `name` that shows entry `index` of the first dimension of dataset `source` of the same file, which has
/// the dimensions `shape`: a view, no copy.
void view_entry(hid_t file, const std::string& name, const char* source, const Extent& shape, hsize_t index,
                const std::string& units);

}  // namespace ritz::format
