// What is in a model file, dataset by dataset, whatever parts it has.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "ritz/format/reader.hpp"

namespace ritz::format {

struct DatasetInfo {
  std::string path;  ///< the first of its names
  std::vector<std::int64_t> shape;
  std::string units;
  std::uint64_t bytes = 0;  ///< stored; 0 for a virtual dataset
  bool is_virtual = false;  ///< a view of other datasets: has no bytes and no checksum of its own
};

/// Every dataset once (a hard link is not a second dataset): bodies, provenance, report, then ParaView's own.
/// Throws InputError for a dataset without units or whose description is damaged.
std::vector<DatasetInfo> contents(const ModelReader& in);

/// Reads all of a dataset that is not virtual and compares its checksum. Throws InputError when it differs.
void verify(const ModelReader& in, const DatasetInfo& dataset);

}  // namespace ritz::format
