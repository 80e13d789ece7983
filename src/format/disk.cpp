#include "disk.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace ritz::format {

namespace {

bool sync(const std::filesystem::path& path, int flags) {
  const int file = ::open(path.c_str(), flags);
  if (file < 0) return false;
  const bool synced = ::fsync(file) == 0;
  return (::close(file) == 0) && synced;
}

/// ParaView goes by the ending. A convenience: where no link can be made, or a real file stands in its place, none is.
void link_beside(const std::filesystem::path& path) {
  auto link = path;
  link.replace_extension(".vtkhdf");
  std::error_code ignored;
  if (link == path) return;
  const auto there = std::filesystem::symlink_status(link, ignored);
  if (std::filesystem::is_symlink(there)) std::filesystem::remove(link, ignored);
  std::filesystem::create_symlink(path.filename(), link, ignored);
}

}  // namespace

int try_create(const std::filesystem::path& path, const std::filesystem::path& part) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return EISDIR;
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0) return errno;
  ::close(file);
  return 0;
}

bool reserve(const std::filesystem::path& path, std::uint64_t bytes) {
  rlimit longest{};
  if (::getrlimit(RLIMIT_FSIZE, &longest) == 0 && bytes > longest.rlim_cur) return false;
  const int file = ::open(path.c_str(), O_WRONLY);
  if (file < 0) return false;
  const int failed = ::fallocate(file, FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(bytes)) == 0 ? 0 : errno;
  ::close(file);
  return failed != ENOSPC && failed != EDQUOT && failed != EFBIG;
}

bool publish(const std::filesystem::path& part, const std::filesystem::path& path) {
  std::error_code ignored;
  std::filesystem::resize_file(part, std::filesystem::file_size(part, ignored), ignored);  // lets go unused room
  if (!sync(part, O_RDONLY)) return false;
  if (std::rename(part.c_str(), path.c_str()) != 0) return false;
  sync(path.has_parent_path() ? path.parent_path() : ".", O_RDONLY | O_DIRECTORY);
  link_beside(path);
  return true;
}

}  // namespace ritz::format
