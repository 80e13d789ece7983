// The datasets of a model file, whatever parts it has.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "ritz/format/reader.hpp"

namespace ritz::format {

struct DatasetInfo {
  std::string path;  ///< one of its names: the first that is found
  std::vector<std::int64_t> shape;
  std::string units;
  std::uint64_t bytes = 0;  ///< size in the file; 0 for a virtual dataset
  bool is_virtual = false;  ///< a view of other datasets: no bytes and no checksum of its own
};

/// Lists every dataset once, though hard links give some several names: those of the bodies, of the provenance, of the
/// report, then those for ParaView alone. Throws InputError for a dataset without units or with a damaged header.
std::vector<DatasetInfo> contents(const ModelReader& in);

/// Reads the whole dataset and compares its checksum; does nothing for a virtual one. Throws InputError when the
/// checksum differs.
void verify(const ModelReader& in, const DatasetInfo& dataset);

}  // namespace ritz::format
