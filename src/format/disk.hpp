// From a finished file beside the real one to the real one, so that no reader ever sees half of it. POSIX, but for
// the reservation of disk space, which is Linux's.
#pragma once
#include <cstdint>
#include <filesystem>

namespace ritz::format {

/// Creates an empty `part`; 0, or the errno that says why neither it nor, later, `path` could be written.
int try_create(const std::filesystem::path& path, const std::filesystem::path& part);

/// Takes the room for the first `bytes` of a file without changing its contents or length; false when the disk has not
/// got it or the process may not write so long a file. True where the file system cannot tell.
bool reserve(const std::filesystem::path& file, std::uint64_t bytes);

/// Syncs `part` to the disk, renames it to `path` and makes the link with the ending .vtkhdf. False when it failed
/// before the renaming took place.
bool publish(const std::filesystem::path& part, const std::filesystem::path& path);

}  // namespace ritz::format
