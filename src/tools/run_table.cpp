#include "run_table.hpp"

#include <cerrno>

#include "ritz/files/failure.hpp"

namespace ritz::tools {

TableFile::TableFile(const std::filesystem::path& path) : file_(path), out_(file_.part(), std::ios::binary) {
  out_.precision(15);
  check();
}

void TableFile::check() {
  if (!out_) files::fail_to_write(file_.path(), errno);
}

void TableFile::finish() {
  errno = 0;
  out_.close();
  check();
  file_.finish();
}

}  // namespace ritz::tools
