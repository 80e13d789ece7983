// Disk operations for a model file besides its bytes. POSIX, except the reservation of disk space, which is Linux's.
#pragma once
#include <cstdint>
#include <filesystem>

namespace ritz::format {

/// Reserves disk space for the first `bytes` of a file without changing its contents or its length. Returns 0, or the
/// errno for a full disk or a limit on the length of files; 0 also where the file system cannot tell.
int reserve(const std::filesystem::path& file, std::uint64_t bytes);

/// Releases reserved space that was not used.
void release_room(const std::filesystem::path& file);

/// Makes the link PATH with the ending .hdf, which ParaView requires. Does nothing where no link can be made or a
/// real file stands there.
void link_beside(const std::filesystem::path& path);

}  // namespace ritz::format
