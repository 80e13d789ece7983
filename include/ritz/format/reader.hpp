// A model file being read. Parts are read by the functions of parts.hpp, so that a program reads only what it uses.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ritz/format/schema.hpp"
#include "ritz/format/stored_file.hpp"

namespace ritz::format {

/// An open model. Opening checks that it is a complete HDF5 file, a ritz model, of a version this library reads, and
/// that every dataset in it is kept as ritz writes them (see survey).
class ModelReader : public StoredFile {
 public:
  /// Throws InputError: as StoredFile, and for what is not a model, or too new.
  explicit ModelReader(const std::filesystem::path& path);
  /// The same from the file's bytes (which are copied); `name` stands for the path in messages.
  explicit ModelReader(std::span<const std::byte> image, std::string name = "model in memory");

  /// The names of the bodies in the file, in the order they were written in.
  std::vector<std::string> bodies() const;
  /// Throws InputError, which names the nearest body that there is, unless the file has body `name`.
  void require_body(std::string_view name) const;
  /// Throws InputError when there is none.
  std::string first_body() const;
  /// Whether body `body` has part `part`: schema::geometry, basis, modes, reduction, polynomial, inertia or loads.
  bool has(std::string_view part, std::string_view body = schema::default_body) const;

  int minor_version() const { return minor_; }

 private:
  void check_root();

  int minor_ = 0;
};

}  // namespace ritz::format
