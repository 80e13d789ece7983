// Reserves the output names of a run, or refuses them, before the work begins.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ritz::files {

/// A file that a run reads or writes.
struct Named {
  std::string said;  ///< what messages call it: "option -output m.h5"
  std::filesystem::path path;
};

/// The files that a run reads and writes.
struct Plan {
  std::vector<Named> outputs;           ///< the first is the main one; none if the run writes reports alone
  std::vector<Named> links = {};        ///< links that are made beside the outputs if nothing stands in their place
  std::vector<Named> inputs = {};       ///< none of them may be overwritten
  std::vector<Named> replaceable = {};  ///< inputs that the first output alone may replace (-restart)
  std::vector<Named> reports = {};      ///< outputs that libraries (PETSc) write during the run; `verify` ignores them
};

/// Reserves the names of a run's outputs until it ends. Of two runs on one machine that would write the same name, the
/// second is refused at its start. Where runs do not see each other (other machines, containers), `verify` refuses the
/// one that publishes second. Nothing is written to reserve a name, so nothing is left behind however the run ends.
class Claim {
 public:
  /// Throws InputError when an output has no folder, or a folder that cannot be written to; when it is a folder, a
  /// device, a named pipe, a socket or a symbolic link; when it is, by its name or as the same file, another output or
  /// an input; and when another run is writing it. If the program is interrupted from now on, it says that the first
  /// output was not written or is what it was.
  explicit Claim(Plan plan);
  ~Claim();
  Claim(Claim&& other) noexcept;
  Claim& operator=(Claim&&) = delete;

  /// The same check for inputs that become known later, such as files that a mesh includes.
  void refuse(const std::vector<Named>& inputs) const;

  /// Throws InputError when an output's name has been taken or its file replaced since the start. Call this when
  /// everything is written, before the first file is renamed.
  void verify() const;

  /// What the run says of the files whose names it takes from earlier runs: "replaced m.h5, m.xdmf"; empty if there
  /// were none.
  std::string replaced() const;

  /// If the program is interrupted from now on, it says that the first output is complete.
  void say_published() const;

 private:
  /// The identity of a file and of its version.
  struct Version {
    std::uint64_t device, file;
    std::int64_t seconds, nanoseconds, bytes;
    bool operator==(const Version&) const = default;
  };
  static std::optional<Version> version(const std::filesystem::path& path);
  void hold(const Named& output);
  std::vector<Named> written() const;  ///< outputs and reports

  Plan plan_;
  std::vector<std::optional<Version>> before_;  ///< what stood at each output's name at the start
  std::vector<int> held_;                       ///< one socket for each reserved name
};

}  // namespace ritz::files
