// A model file being read. Parts are read by the functions of parts.hpp, so that a program reads only what it uses.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/format/handle.hpp"
#include "ritz/format/schema.hpp"

namespace ritz::format {

/// An open model. Opening checks that it is a complete HDF5 file, a ritz model, and of a version this library reads.
class ModelReader {
 public:
  /// Throws InputError: no such file, a folder, a half-written .part, not HDF5, truncated, not a model, too new.
  explicit ModelReader(const std::filesystem::path& path);
  /// The same from the file's bytes (which are copied); `name` stands for the path in messages.
  explicit ModelReader(std::span<const std::byte> image, std::string name = "model in memory");

  /// The names of the bodies in the file.
  std::vector<std::string> bodies() const;
  /// Whether body `body` has part `part`: schema::geometry, basis, modes, reduction, polynomial, inertia or loads.
  bool has(std::string_view part, std::string_view body = schema::default_body) const;

  hid_t file() const { return file_.get(); }
  /// What messages call it.
  const std::string& name() const { return name_; }
  int minor_version() const { return minor_; }

 private:
  void check_root();

  std::string name_;
  File file_;
  int minor_ = 0;
};

}  // namespace ritz::format
