// A file that takes its final name only when it is complete; the names of files beside an output; and, in words for the
// user, why a file could not be written.
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ritz::files {

/// What `error`, a value of errno, means: "the disk is full", "the name is too long". For 0, an unknown error: "is the
/// disk full?".
std::string why(int error);

/// Throws "cannot write WHAT: WHY; what to do", where WHAT is usually a path: InputError where another name or folder
/// would help (no such folder, no permission, a name too long), else NumericalError (a full disk, a quota, a limit).
[[noreturn]] void fail_to_write(const std::string& what, int error);

/// The folder of a file, "." if its path names none.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// The path of the table `name` of the run that writes `output`: part.h5 -> part.NAME.csv in the same folder, so that
/// runs with different outputs share no files. Beside the default outputs model.h5, motion.h5 and full.h5 it is
/// NAME.csv.
std::filesystem::path table_beside(const std::filesystem::path& output, std::string_view name);

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
