#include "part_file.hpp"

#include <fstream>
#include <utility>

#include "ritz/base/error.hpp"

namespace ritz::tools {

namespace fs = std::filesystem;

PartFile::PartFile(fs::path path) : path_(std::move(path)), part_(path_.string() + ".part") {
  const auto refuse = [&](const std::string& why) { throw InputError("cannot write " + path_.string() + ": " + why); };
  const fs::path folder = path_.has_parent_path() ? path_.parent_path() : ".";
  if (!fs::is_directory(folder)) refuse("there is no folder " + folder.string());
  if (fs::is_directory(path_)) refuse("it is a folder");
  if (!std::ofstream(part_)) refuse("check the permissions of its folder");
}

PartFile::~PartFile() {
  std::error_code ignored;
  if (!part_.empty()) fs::remove(part_, ignored);
}

PartFile::PartFile(PartFile&& other) noexcept
    : path_(std::move(other.path_)), part_(std::exchange(other.part_, fs::path())) {}

void PartFile::commit() {
  fs::rename(part_, path_);
  part_.clear();
}

}  // namespace ritz::tools
