// Refuses inputs that are not regular files.
#pragma once
#include <filesystem>
#include <string>
#include <system_error>

#include "ritz/base/error.hpp"

namespace ritz {

/// Throws InputError, "`given` is not a regular file ...", for pipes, devices, sockets and folders, of which reading
/// could block or never end. Does nothing for a file that does not exist: opening it reports that.
inline void refuse_irregular(const std::filesystem::path& path, const std::string& given) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw InputError(given + (std::filesystem::is_directory(status)
                                ? " is a folder; name a file in it"
                                : " is not a regular file; save what a pipe or device holds as a file first"));
}

}  // namespace ritz
