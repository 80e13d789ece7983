// Wrong models that are sound HDF5 files, as a stranger with a library of HDF5 makes them: damaged bytes alone rarely
// get past HDF5's own checksums.
#pragma once
#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "ritz/format/handle.hpp"

namespace ritz::fuzz {

/// Numbers out of the bytes of an input, zeros when they have run out.
class Choices {
 public:
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool ended() const { return bytes_.empty(); }
  std::uint64_t number(std::size_t bytes);
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(number(1)) % bound; }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// The paths of all groups and datasets.
std::vector<std::string> paths_in(const std::filesystem::path& path);

/// Overwrites up to four runs of bytes, wherever they stand.
void damage(std::vector<std::byte>& image, Choices& choices);

/// A file with up to four things changed: a link, a dataset (shape, type, layout, values; where it can be, with the
/// right checksum), or an attribute. What HDF5 refuses to do is not done. The file is closed again: an image of an open
/// one has a superblock with a wrong checksum. Empty when it is larger than what a run should try, or HDF5 crashed.
std::vector<std::byte> edited(const std::vector<std::byte>& image, const std::vector<std::string>& paths,
                              Choices choices);

}  // namespace ritz::fuzz
