// What may be read as an input.
#pragma once
#include <filesystem>
#include <string>
#include <system_error>

#include "ritz/base/error.hpp"

namespace ritz {

/// Throws InputError, "`given` is not a regular file ...", for pipes, devices, sockets and folders: to read them could
/// wait or go on for ever. A file that is not there is left to who opens it.
inline void refuse_irregular(const std::filesystem::path& path, const std::string& given) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw InputError(given + (std::filesystem::is_directory(status)
                                ? " is a folder; name a file in it"
                                : " is not a regular file; save what a pipe or device holds as a file first"));
}

}  // namespace ritz
