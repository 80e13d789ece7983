// A file that takes its name only when it is whole.
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ritz::files {

/// What makes `path` unfit as the name of a new file: "is a folder", "is a device", "is a symbolic link", "is a named
/// pipe", "is a socket"; empty where nothing or a plain file stands. A link is refused rather than followed or
/// replaced: either could surprise. Throws InputError where the path cannot even be asked about, as a name too long.
std::string unfit(const std::filesystem::path& path);

/// A new file beside PATH, with a name of its own that nobody can guess and that ends in .part; another run's, or a
/// link that somebody else put there, is never written to. `publish` renames it to PATH, over an earlier file; what was
/// not published is removed, also when the program is interrupted (interruption.hpp).
/// Who may write to the folder can still swap the file behind our back: the folder is the user's.
class PartFile {
 public:
  /// Creates it, empty. Throws InputError or NumericalError when that cannot be done, or when PATH is unfit.
  explicit PartFile(std::filesystem::path path);
  ~PartFile();
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& part() const { return part_; }

  /// Replaces its contents. Throws as fail_to_write does.
  void write(std::string_view text) const;

  /// Everything of publishing that a disk can refuse: brings the contents to the disk. Its writer has closed it.
  /// Throws as fail_to_write does.
  void finish() const;

  /// Gives it its name. Throws as fail_to_write does.
  void publish();

 private:
  std::filesystem::path path_, part_;  ///< part_ is empty when there is nothing left to remove
  std::optional<std::size_t> doomed_;  ///< where the list of what an interruption removes has it
};

}  // namespace ritz::files
