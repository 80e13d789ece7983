// What a model file asks of the disk besides its bytes. POSIX, but for the reservation of disk space, which is Linux's.
#pragma once
#include <cstdint>
#include <filesystem>

namespace ritz::format {

/// Takes the room for the first `bytes` of a file without changing its contents or length: 0, or the errno that says
/// that the disk has not got it or that the process may not write so long a file. 0 where the file system cannot tell.
int reserve(const std::filesystem::path& file, std::uint64_t bytes);

/// Gives back what was reserved and not used.
void release_room(const std::filesystem::path& file);

/// Makes the link PATH with the ending .vtkhdf, as ParaView goes by the ending. A convenience: where no link can be
/// made, or a real file stands in its place, none is.
void link_beside(const std::filesystem::path& path);

}  // namespace ritz::format
