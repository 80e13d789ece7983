// What a program does when a signal asks it to end (SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, or SIGPIPE when nobody
// reads its output): it removes half-written files, says in one sentence what was kept, and ends by that signal, as
// shells expect.
//
// This is the only global state of the project, because a signal handler has no other way to find its data. The handler
// calls only what POSIX allows there (unlink, write, raise), and reads lists of fixed size.
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace ritz::files {

/// Installs the handler. A signal that is ignored stays ignored (nohup). SIGXFSZ is ignored, so that exceeding a limit
/// on file size is a failed write, as on a full disk. `program` begins the sentence.
void watch_interruptions(const std::string& program);

/// Sets what the sentence says: "NAME is what it was". Unless this is called, nothing is printed; on several ranks only
/// one calls it.
void say_when_interrupted(const std::string& kept);

/// Adds a file to those that an interruption removes, and returns its index in the list. Nothing is added or returned
/// when the list (32 files) is full or the name (up to 4095 bytes) is too long.
std::optional<std::size_t> doom(const std::filesystem::path& file);
/// Takes entry `index` off the list.
void spare(std::size_t index);

/// Delays interruptions while an object of this class exists: used while several files are renamed.
class Uninterrupted {
 public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
};

}  // namespace ritz::files
