// A model file being written. Parts are written by the functions of parts.hpp.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "ritz/base/vote.hpp"
#include "ritz/files/part_file.hpp"
#include "ritz/format/handle.hpp"

namespace ritz::format {

/// How the ranks of a parallel program write one file together; as it stands, one serial program.
/// The property lists stay the caller's and must outlive the writer.
struct Access {
  hid_t file = H5P_DEFAULT;      ///< file access (H5Pset_fapl_mpio)
  hid_t transfer = H5P_DEFAULT;  ///< dataset transfer (H5Pset_dxpl_mpio)
  bool writes_small = true;      ///< true on exactly one rank: it writes what is replicated, and names the file
  /// *Collective*: the sum of all ranks' values modulo 2^64, the same on every rank. Absent: one rank.
  std::function<std::uint64_t(std::uint64_t)> sum;
  /// Whether all ranks say yes. A rank that says no waits for the others for seconds only. Absent: one rank.
  std::function<Vote(bool)> vote;
};

/// Writes a part file of its own beside FILE and renames it to FILE on commit: there is never half a model under the
/// final name.
/// Every member and every write_* function is *Collective*: all ranks call it in the same order. A failure on one rank
/// is thrown on all.
class ModelWriter {
 public:
  /// Creates the part file. Throws, on all ranks alike, as files::PartFile does.
  explicit ModelWriter(std::filesystem::path path, Access access = {});
  /// Removes the part file unless the model was committed. *Collective*; a rank whose peers are elsewhere, because it
  /// failed alone, waits for them for seconds only, and leaves the file open, as closing it is collective.
  ~ModelWriter();
  ModelWriter(const ModelWriter&) = delete;
  ModelWriter& operator=(const ModelWriter&) = delete;

  /// Flushes, closes and syncs to the disk: all that a disk can refuse. Throws std::runtime_error when a write fails.
  /// Nothing can be written afterwards.
  void finish();

  /// Finishes what is not finished yet, renames, and makes the link PATH with the ending .vtkhdf beside it (where the
  /// file system can, and never in the place of a real file), through which ParaView sees the first body. Of several
  /// bodies each gets a small file of its own, MODEL.BODY.vtkhdf. Throws std::runtime_error.
  void commit();

  /// Takes disk space for `more` bytes and HDF5's records of them; throws std::runtime_error when there is none.
  void make_room(std::uint64_t more) const;

  hid_t file() const { return file_.get(); }
  const Access& access() const { return access_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  struct Uncreated {};
  /// Once this is done, the destructor runs whatever the public constructor throws.
  ModelWriter(Uncreated, std::filesystem::path path, Access access);
  void create_part();
  void reserve_on_disk(std::uint64_t bytes) const;

  std::filesystem::path path_;
  std::filesystem::path part_;                ///< on all ranks; empty before it is created and after it is committed
  std::optional<files::PartFile> part_file_;  ///< of the rank that writes what is small
  std::vector<files::PartFile> views_;        ///< of that rank: what shows one of several bodies
  Access access_;
  File file_;
};

}  // namespace ritz::format
