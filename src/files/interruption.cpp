#include "ritz/files/interruption.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>

namespace ritz::files {
namespace {

struct Doomed {
  std::atomic<bool> taken = false, listed = false;
  std::array<char, 4096> path{};
};

/// Texts are never changed in place: a handler may be reading one.
struct Text {
  std::array<char, 8192> bytes{};
  std::atomic<std::size_t> length = 0;
};

std::array<Doomed, 32> doomed;
std::array<Text, 2> sentences;
std::atomic<int> sentence = -1;  ///< the one that holds
std::atomic<int> waiting = 0;    ///< Uninterrupted that live
std::atomic<int> came = 0;       ///< a signal meanwhile
std::array<char, 64> program_name{};

extern "C" void end_by(int signal) {
  const int before = errno;
  if (waiting > 0) {
    came = signal;
    errno = before;
    return;
  }
  for (auto& file : doomed)
    if (file.listed) ::unlink(file.path.data());
  if (const int which = sentence.exchange(-1); which >= 0) {
    const auto& text = sentences[static_cast<std::size_t>(which)];
    if (::write(STDERR_FILENO, text.bytes.data(), text.length) < 0) errno = before;
  }
  ::signal(signal, SIG_DFL);
  ::raise(signal);  // blocked until this returns; then it ends the process
}

void answer(int signal) {
  struct sigaction now {
  }, ours{};
  ::sigaction(signal, nullptr, &now);
  if (now.sa_handler == SIG_IGN) return;
  ours.sa_handler = end_by;
  ::sigfillset(&ours.sa_mask);
  ::sigaction(signal, &ours, nullptr);
}

}  // namespace

void watch_interruptions(const std::string& program) {
  program.copy(program_name.data(), program_name.size() - 1);
  ::signal(SIGXFSZ, SIG_IGN);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGPIPE}) answer(signal);
}

void say_when_interrupted(const std::string& kept) {
  const std::string said = std::string(program_name.data()) + ": interrupted; " + kept + "\n";
  const int free = sentence == 0 ? 1 : 0;
  auto& text = sentences[static_cast<std::size_t>(free)];
  text.length = said.copy(text.bytes.data(), text.bytes.size());
  sentence = free;
}

std::optional<std::size_t> doom(const std::filesystem::path& file) {
  const std::string& name = file.native();
  if (name.size() >= doomed[0].path.size()) return std::nullopt;
  for (std::size_t i = 0; i < doomed.size(); ++i) {
    if (doomed[i].taken.exchange(true)) continue;
    std::memcpy(doomed[i].path.data(), name.c_str(), name.size() + 1);
    doomed[i].listed = true;
    return i;
  }
  return std::nullopt;
}

void spare(std::size_t index) {
  doomed[index].listed = false;
  doomed[index].taken = false;
}

Uninterrupted::Uninterrupted() { ++waiting; }

Uninterrupted::~Uninterrupted() {
  if (--waiting == 0)
    if (const int signal = came.exchange(0); signal != 0) ::raise(signal);
}

}  // namespace ritz::files
