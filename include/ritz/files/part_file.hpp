// A file that takes its final name only when it is complete.
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ritz::files {

/// Why `path` cannot be the name of a new file: "is a folder", "is a device", "is a symbolic link", "is a named pipe"
/// or "is a socket"; empty if there is a regular file or nothing. A link is refused, as following it and replacing it
/// could both surprise. Throws as fail_to_write does where the path cannot be examined, such as a name that is too
/// long.
std::string unfit(const std::filesystem::path& path);

/// A new file beside PATH, with an unpredictable name that ends in .part; it never writes to another run's file, or to
/// a link that somebody else made. `publish` renames it to PATH, replacing an earlier file. A file that was not
/// published is removed by the destructor, and when the program is interrupted (interruption.hpp). Whoever may write to
/// the folder could still exchange the file: the folder must be trusted.
class PartFile {
 public:
  /// Creates the file, empty. Throws InputError or NumericalError when that fails, or when PATH is unfit.
  explicit PartFile(std::filesystem::path path);
  ~PartFile();
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& part() const { return part_; }

  /// Replaces the contents. Throws as fail_to_write does.
  void write(std::string_view text) const;

  /// Flushes the contents to the disk, which is all of publishing that can fail for lack of space. Whoever wrote the
  /// file must have closed it. Throws as fail_to_write does.
  void finish() const;

  /// Renames the file to PATH. Throws as fail_to_write does.
  void publish();

 private:
  std::filesystem::path path_, part_;  ///< part_ is empty when there is nothing left to remove
  std::optional<std::size_t> doomed_;  ///< index in the list of files that an interruption removes
};

}  // namespace ritz::files
