// The few verbs of HDF5 that writing a motion takes.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ritz/format/handle.hpp"

namespace ritz::tools {

using Shape = std::vector<hsize_t>;

/// Throws std::runtime_error that asks for the disk.
void require_written(bool good);

void write_attribute(hid_t object, const char* name, const std::string& text);

/// A new dataset of 64-bit floats with the attribute "units".
format::Dataset create_floats(hid_t file, const char* name, const Shape& shape, const std::string& units);
/// A new dataset that is written whole; units "1".
void write_integers(hid_t file, const char* name, std::span<const std::int64_t> values);
/// Writes `count` numbers along each dimension from `start` on.
void write_block(const format::Dataset& dataset, const Shape& start, const Shape& count, const double* values);
/// A dataset `name` that shows entry `index` of the first dimension of dataset `source` of the same file, which has
/// the dimensions `shape`: a view, no copy.
void view_entry(hid_t file, const std::string& name, const char* source, const Shape& shape, hsize_t index,
                const std::string& units);

}  // namespace ritz::tools
