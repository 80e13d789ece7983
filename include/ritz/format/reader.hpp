// Reading of a model file. Parts are read by the functions of parts.hpp, so that a program reads only what it uses;
// every dataset, whatever its part, can be listed and verified.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/format/schema.hpp"
#include "ritz/format/stored_file.hpp"

namespace ritz::format {

/// An open model file. Opening checks that it is a complete HDF5 file, a ritz model, of a version that this library
/// reads, and that every dataset is stored as ritz writes it (see survey).
class ModelReader : public StoredFile {
 public:
  /// Throws InputError as StoredFile does, and for a file that is not a model or of a newer major version.
  explicit ModelReader(const std::filesystem::path& path);
  /// The same from the bytes of a file, which are copied; `name` stands for the path in messages.
  explicit ModelReader(std::span<const std::byte> image, std::string name = "model in memory");

  /// The names of the bodies in the file, in the order in which they were written.
  std::vector<std::string> bodies() const;
  /// Throws an InputError that names the nearest body, unless the file has a body `name`.
  void require_body(std::string_view name) const;
  /// The name of the first body. Throws InputError when there is none.
  std::string first_body() const;
  /// Whether the body has the part `part`: schema::geometry, basis, modes, reduction, polynomial, inertia or loads.
  bool has(std::string_view part, std::string_view body = schema::default_body) const;

  const schema::Version& version() const { return version_; }

 private:
  void check_root();

  schema::Version version_ = {0, 0};
};

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
