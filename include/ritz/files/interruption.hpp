// What a program does when it is asked to end (SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, or SIGPIPE, when nobody reads
// its output): half-written files are removed, one sentence says what was kept, and it dies of the signal, as shells
// expect.
//
// Only here does the project keep global state: a signal's handler sees nothing else. It calls what POSIX allows there
// (unlink, write, raise), and reads lists of fixed size.
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace ritz::files {

/// From now on interruptions are answered so; a signal that is ignored stays ignored (nohup). SIGXFSZ is ignored: a
/// file that may not grow is a write that fails, as on a full disk. `program` begins the sentence.
void watch_interruptions(const std::string& program);

/// What the sentence says: "NAME is what it was". Without it, nothing is said: on all ranks but one.
void say_when_interrupted(const std::string& kept);

/// Adds to what an interruption removes. Nothing where the list (of 32) or the name (of 4096 bytes) is too long.
std::optional<std::size_t> doom(const std::filesystem::path& file);
/// Takes entry `index` off the list again.
void spare(std::size_t index);

/// While one lives, an interruption waits: for files that get their names one after another.
class Uninterrupted {
 public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
};

}  // namespace ritz::files
