// The names that a run will write, refused or taken before the work begins.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ritz::files {

/// A file that a run reads or writes.
struct Named {
  std::string said;  ///< what a message calls it: "option -output m.h5"
  std::filesystem::path path;
};

/// What a run reads and writes besides.
struct Plan {
  std::vector<Named> outputs;           ///< the first is what the run is for; none where there are reports alone
  std::vector<Named> links = {};        ///< made beside them where nothing stands in their place
  std::vector<Named> inputs = {};       ///< none of them may be written over
  std::vector<Named> replaceable = {};  ///< the same, but the first output may take their place (-restart)
  std::vector<Named> reports = {};      ///< outputs that others (PETSc) write as the run goes: not for `verify`
};

/// Holds the names of a run's outputs until it ends. Of two runs of one machine that would write one name, the second
/// is refused at its start; where runs do not see each other (other machines, containers), whoever publishes second is
/// refused by `verify`. Nothing is written to hold a name, so nothing stays behind whatever ends the run.
class Claim {
 public:
  /// Throws InputError when an output has no folder or one that cannot be written to; is a folder, a device, a named
  /// pipe, a socket or a symbolic link; or is, by its name or as the same file, another output or an input; or is being
  /// written by another run. An interruption from now on says that the first output is what it was.
  explicit Claim(Plan plan);
  ~Claim();
  Claim(Claim&& other) noexcept;
  Claim& operator=(Claim&&) = delete;

  /// For inputs that only reading another shows (files that a mesh includes): as at the start.
  void refuse(const std::vector<Named>& inputs) const;

  /// Throws InputError when something else has come to stand at an output's name since. To be called when all is
  /// written, before the first file gets its name.
  void verify() const;

  /// An interruption from now on says that the first output is whole.
  void say_published() const;

 private:
  /// Which file stood there, and which version of it.
  struct Version {
    std::uint64_t device, file;
    std::int64_t seconds, nanoseconds, bytes;
    bool operator==(const Version&) const = default;
  };
  static std::optional<Version> version(const std::filesystem::path& path);
  void hold(const Named& output);
  std::vector<Named> written() const;  ///< outputs and reports

  Plan plan_;
  std::vector<std::optional<Version>> before_;
  std::vector<int> held_;  ///< sockets
};

}  // namespace ritz::files
