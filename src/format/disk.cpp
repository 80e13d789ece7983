#include "disk.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace ritz::format {

int reserve(const std::filesystem::path& path, std::uint64_t bytes) {
  rlimit longest{};
  if (::getrlimit(RLIMIT_FSIZE, &longest) == 0 && bytes > longest.rlim_cur) return EFBIG;
  const int file = ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return errno;
  const int failed = ::fallocate(file, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes)) == 0 ? 0 : errno;
  ::close(file);
  return failed == ENOSPC || failed == EDQUOT || failed == EFBIG || failed == EIO ? failed : 0;
}

void release_room(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::resize_file(file, std::filesystem::file_size(file, ignored), ignored);
}

void link_beside(const std::filesystem::path& path) {
  auto link = path;
  link.replace_extension(".hdf");
  std::error_code ignored;
  if (link == path) return;
  const auto there = std::filesystem::symlink_status(link, ignored);
  if (std::filesystem::is_symlink(there)) std::filesystem::remove(link, ignored);
  std::filesystem::create_symlink(path.filename(), link, ignored);
}

}  // namespace ritz::format
