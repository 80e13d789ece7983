#include "ritz/files/claim.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "ritz/base/error.hpp"
#include "ritz/files/interruption.hpp"
#include "ritz/files/part_file.hpp"

namespace ritz::files {
namespace {

namespace fs = std::filesystem;

bool same_name(const fs::path& a, const fs::path& b) {
  std::error_code none;
  return a.filename() == b.filename() && fs::equivalent(folder_of(a), folder_of(b), none);
}

/// One name in one folder, or one file under two names.
bool same(const fs::path& a, const fs::path& b) {
  std::error_code none;
  return same_name(a, b) || fs::equivalent(a, b, none);
}

void refuse_place(const Named& output) {
  const auto folder = folder_of(output.path);
  if (output.path.filename().empty()) throw InputError(output.said + " is a folder; name a file in it");
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw InputError(output.said + ": there is no folder " + folder.string());
  if (const auto what = unfit(output.path); !what.empty())
    throw InputError(output.said + " " + what + "; choose another name, or move it away");
  const PartFile takes_files(output.path);
}

void refuse_input(const Named& output, const std::vector<Named>& inputs) {
  for (const auto& input : inputs)
    if (same(output.path, input.path))
      throw InputError(output.said + " would overwrite an input, " + input.said + ": choose another name");
}

/// By name alone: that a link of an earlier run leads to an output is as it should be.
void refuse_link(const Named& link, const std::vector<Named>& others) {
  for (const auto& other : others)
    if (same_name(link.path, other.path))
      throw InputError(link.said + " would take the place of " + other.said + ": choose another name");
}

/// A name of this machine that goes with the process, in Linux's abstract space of sockets: device and number of the
/// folder, and a hash of the file's name (FNV-1a).
sockaddr_un address(const fs::path& path, socklen_t& length) {
  struct stat folder {};
  ::stat(folder_of(path).c_str(), &folder);
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : path.filename().string()) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const int written =
      std::snprintf(address.sun_path + 1, sizeof address.sun_path - 1, "ritz-output-%llx-%llx-%llx",
                    static_cast<unsigned long long>(folder.st_dev), static_cast<unsigned long long>(folder.st_ino),
                    static_cast<unsigned long long>(hash));
  length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + static_cast<std::size_t>(written));
  return address;
}

}  // namespace

std::optional<Claim::Version> Claim::version(const fs::path& path) {
  struct stat there {};
  if (::lstat(path.c_str(), &there) != 0) return std::nullopt;
  return Version{there.st_dev, there.st_ino, there.st_mtim.tv_sec, there.st_mtim.tv_nsec, there.st_size};
}

Claim::Claim(Plan plan) : plan_(std::move(plan)) {
  const auto outputs = written();
  refuse(plan_.inputs);
  for (const auto& link : plan_.links) refuse_link(link, outputs);
  for (std::size_t i = 1; i < outputs.size(); ++i) {
    refuse_input(outputs[i], plan_.replaceable);
    for (std::size_t j = 0; j < i; ++j)
      if (same(outputs[i].path, outputs[j].path))
        throw InputError(outputs[i].said + " is a file that the run writes besides, as " + outputs[j].said +
                         ": choose another name");
  }
  for (const auto& output : plan_.outputs) before_.push_back(version(output.path));
  if (!plan_.outputs.empty())  // before the first file is made, as an interruption may come as soon as it is there
    say_when_interrupted(outputs.front().path.string() + (before_.front() ? " is what it was" : " was not written"));
  for (const auto& output : outputs) refuse_place(output);
  // What the run is for first, as that is the name to tell; the others in one order for all runs, so that of two that
  // share them one gets them all.
  auto sorted = outputs;
  std::sort(sorted.begin() + 1, sorted.end(),
            [](const Named& a, const Named& b) { return a.path.filename() < b.path.filename(); });
  try {
    for (const auto& output : sorted) hold(output);
  } catch (...) {
    for (const int held : held_) ::close(held);
    throw;
  }
}

Claim::~Claim() {
  for (const int held : held_) ::close(held);
}

Claim::Claim(Claim&& other) noexcept
    : plan_(std::move(other.plan_)), before_(std::move(other.before_)), held_(std::exchange(other.held_, {})) {}

std::vector<Named> Claim::written() const {
  auto all = plan_.outputs;
  all.insert(all.end(), plan_.reports.begin(), plan_.reports.end());
  return all;
}

void Claim::hold(const Named& output) {
  const int held = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (held < 0) return;  // without sockets, `verify` is what is left
  socklen_t length = 0;
  const auto name = address(output.path, length);
  if (::bind(held, reinterpret_cast<const sockaddr*>(&name), length) == 0) {
    held_.push_back(held);
    return;
  }
  const bool taken = errno == EADDRINUSE;
  ::close(held);
  if (taken)
    throw InputError(output.said + ": another run is writing this file; wait for its end, or choose another name");
}

void Claim::refuse(const std::vector<Named>& inputs) const {
  for (const auto& output : written()) refuse_input(output, inputs);
  for (const auto& link : plan_.links) refuse_link(link, inputs);
}

void Claim::verify() const {
  for (std::size_t i = 0; i < before_.size(); ++i)
    if (const auto now = version(plan_.outputs[i].path); now && now != before_[i])
      throw InputError(plan_.outputs[i].said +
                       ": another run has written this file meanwhile, and this one leaves it alone; run again, or "
                       "choose another name");
}

std::string Claim::replaced() const {
  std::string files;
  for (std::size_t i = 0; i < before_.size(); ++i)
    if (before_[i]) files += (files.empty() ? "replaced " : ", ") + plan_.outputs[i].path.string();
  return files;
}

void Claim::say_published() const { say_when_interrupted(plan_.outputs.front().path.string() + " is whole"); }

}  // namespace ritz::files
