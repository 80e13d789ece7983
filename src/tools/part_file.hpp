// A file that takes its name only when it is whole.
#pragma once
#include <filesystem>

namespace ritz::tools {

/// Stands for PATH while PATH.part is written; what was not committed is removed.
class PartFile {
 public:
  /// Creates PATH.part, empty. Throws InputError when that cannot be done.
  explicit PartFile(std::filesystem::path path);
  ~PartFile();
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& part() const { return part_; }

  /// Renames PATH.part to PATH; its writer has closed it. Throws std::runtime_error when that fails.
  void commit();

 private:
  std::filesystem::path path_, part_;  ///< part_ is empty when there is nothing left to remove
};

}  // namespace ritz::tools
