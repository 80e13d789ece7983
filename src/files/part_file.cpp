#include "ritz/files/part_file.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "ritz/base/error.hpp"
#include "ritz/files/interruption.hpp"

namespace ritz::files {
namespace {

/// Whether another name or another folder is what helps.
bool is_of_the_name(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
    case EISDIR:
    case EACCES:
    case EPERM:
    case EROFS:
    case ENAMETOOLONG:
    case ELOOP:
    case EINVAL: return true;
    default: return false;
  }
}

}  // namespace

std::string why(int error) {
  switch (error) {
    case 0: return "is the disk full?";
    case ENOSPC: return "the disk is full";
    case EDQUOT: return "the disk quota is used up";
    case EFBIG: return "the file would be longer than the limit of this process (ulimit -f) or of the file system";
    case EROFS: return "the file system is read-only";
    case EACCES:
    case EPERM: return "permission is denied";
    case ENAMETOOLONG: return "the name is too long";
    case EMFILE:
    case ENFILE: return "too many files are open (ulimit -n)";
    case EIO: return "the disk reports an error";
    case ENOENT: return "there is no such folder, or it takes no files";
    case ENOTDIR: return "a part of the path is no folder";
    case EISDIR: return "it is a folder";
    case ELOOP: return "too many symbolic links are on the way";
    default: return std::generic_category().message(error);
  }
}

void fail_to_write(const std::string& what, int error) {
  const std::string said = "cannot write " + what + ": " + why(error);
  if (is_of_the_name(error)) throw InputError(said + "; choose a name in a folder that exists and can be written to");
  const bool room = error == 0 || error == ENOSPC || error == EDQUOT;
  throw NumericalError(said + (room ? "; make room and run again" : "; mend that and run again"));
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

std::filesystem::path table_beside(const std::filesystem::path& output, std::string_view name) {
  const auto file = output.filename();
  const bool plain = file == "model.h5" || file == "motion.h5" || file == "full.h5";
  const auto table = std::string(name) + ".csv";
  return output.parent_path() / (plain ? table : file.stem().string() + "." + table);
}

namespace {

namespace fs = std::filesystem;

/// PATH.0123456789abcdef.part; of a long name the beginning only, as a name has at most 255 bytes.
fs::path part_of(const fs::path& path) {
  constexpr std::size_t longest = 255, ending = 22;
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) != sizeof number) fail_to_write(path, errno);
  std::array<char, ending + 1> text{};
  std::snprintf(text.data(), text.size(), ".%016llx.part", static_cast<unsigned long long>(number));
  return folder_of(path) / (path.filename().string().substr(0, longest - ending) + text.data());
}

/// An open file, closed at the end; what fails is said of `path`.
class Open {
 public:
  Open(const fs::path& path, const fs::path& part, int flags)
      : path_(path), file_(::open(part.c_str(), flags | O_CLOEXEC, 0666)) {
    if (file_ < 0) fail_to_write(path_, errno);
  }
  ~Open() { ::close(file_); }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;

  void write(std::string_view text) const {
    while (!text.empty()) {
      const auto written = ::write(file_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail_to_write(path_, errno);
      text.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  /// A file system that cannot sync says so by EINVAL, and has nothing to lose.
  void sync() const {
    if (::fsync(file_) != 0 && errno != EINVAL) fail_to_write(path_, errno);
  }

 private:
  const fs::path& path_;
  int file_;
};

}  // namespace

std::string unfit(const fs::path& path) {
  struct stat there {};
  if (::lstat(path.c_str(), &there) != 0) {
    if (errno != ENOENT) fail_to_write(path, errno);
    return {};
  }
  switch (there.st_mode & S_IFMT) {
    case S_IFREG: return {};
    case S_IFDIR: return "is a folder";
    case S_IFLNK: return "is a symbolic link";
    case S_IFIFO: return "is a named pipe";
    case S_IFSOCK: return "is a socket";
    default: return "is a device";
  }
}

PartFile::PartFile(fs::path path) : path_(std::move(path)) {
  if (const auto what = unfit(path_); !what.empty())
    throw InputError("cannot write " + path_.string() + ": it " + what + "; choose another name, or move it away");
  part_ = part_of(path_);
  doomed_ = doom(part_);  // first: an interruption may come as soon as the file is there
  try {
    const Open created(path_, part_, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
  } catch (...) {
    if (doomed_) spare(*doomed_);
    throw;
  }
}

PartFile::~PartFile() {
  std::error_code ignored;
  if (!part_.empty()) fs::remove(part_, ignored);
  if (doomed_) spare(*doomed_);
}

PartFile::PartFile(PartFile&& other) noexcept
    : path_(std::move(other.path_)),
      part_(std::exchange(other.part_, fs::path())),
      doomed_(std::exchange(other.doomed_, std::nullopt)) {}

void PartFile::write(std::string_view text) const {
  const Open file(path_, part_, O_WRONLY | O_TRUNC | O_NOFOLLOW);
  file.write(text);
}

void PartFile::finish() const { Open(path_, part_, O_RDONLY | O_NOFOLLOW).sync(); }

void PartFile::publish() {
  const Uninterrupted whole;
  if (std::rename(part_.c_str(), path_.c_str()) != 0) fail_to_write(path_, errno);
  part_.clear();
  if (const int folder = ::open(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); folder >= 0) {
    ::fsync(folder);  // a rename that a crash may undo leaves the earlier file, which is whole as well
    ::close(folder);
  }
}

}  // namespace ritz::files
