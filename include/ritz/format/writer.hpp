// Writing of a model file. Parts are written by the functions of parts.hpp.
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

/// How the ranks of a parallel program write one file together; by default a serial program. The property lists belong
/// to the caller and must outlive the writer.
struct Access {
  hid_t file = H5P_DEFAULT;      ///< file access (H5Pset_fapl_mpio)
  hid_t transfer = H5P_DEFAULT;  ///< dataset transfer (H5Pset_dxpl_mpio)
  bool writes_small = true;      ///< true on exactly one rank, which writes what is replicated and renames the file
  /// *Collective*: the sum of the values of all ranks modulo 2^64, on every rank. Absent: one rank.
  std::function<std::uint64_t(std::uint64_t)> sum;
  /// *Collective*: whether all ranks pass true. A rank that passes false waits only seconds for the others (Vote::alone
  /// if they do not come). Absent: one rank.
  std::function<Vote(bool)> vote;
};

#ifdef H5_HAVE_PARALLEL
/// The two property lists of Access for the ranks of `comm`, where HDF5 was built with MPI. They must outlive the
/// writer.
struct ParallelLists {
  Properties file;      ///< of the file, which all ranks open
  Properties transfer;  ///< of the datasets, which all ranks write in one collective call

  explicit ParallelLists(MPI_Comm comm);
};
#endif

/// Writes a part file beside the final path and renames it on commit, so that half a model never has the final name.
/// Every member and every write_* function is *Collective*: all ranks call it in the same order, and a failure on one
/// rank is thrown on all.
class ModelWriter {
 public:
  /// Creates the part file. Throws on all ranks as files::PartFile does.
  explicit ModelWriter(std::filesystem::path path, Access access = {});
  /// *Collective*. Removes the part file unless the model was committed. A rank that failed alone, while the others do
  /// not come, waits for them only seconds; it then leaves the file open, because closing is collective.
  ~ModelWriter();
  ModelWriter(const ModelWriter&) = delete;
  ModelWriter& operator=(const ModelWriter&) = delete;

  /// Flushes, closes and syncs the file: everything that can fail for lack of disk space. Nothing can be written
  /// afterwards. Throws std::runtime_error when a write fails.
  void finish();

  /// Calls finish() if that was not done, renames the file, and makes beside it the link with the ending .hdf
  /// through which ParaView shows the first body (if the file system supports links and no real file stands there).
  /// With several bodies each also gets a small file MODEL.BODY.hdf. Throws std::runtime_error.
  void commit();

  /// Reserves disk space for `more` bytes and for HDF5's records of them. Throws std::runtime_error when there is not
  /// enough.
  void make_room(std::uint64_t more) const;

  hid_t file() const { return file_.get(); }
  const Access& access() const { return access_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  struct Uncreated {};
  /// After this constructor is done, the destructor runs whatever the public constructor throws.
  ModelWriter(Uncreated, std::filesystem::path path, Access access);
  void create_part();
  void reserve_on_disk(std::uint64_t bytes) const;

  std::filesystem::path path_;
  std::filesystem::path part_;                ///< on all ranks; empty before it is created and after commit
  std::optional<files::PartFile> part_file_;  ///< on the rank with writes_small
  std::vector<files::PartFile> views_;        ///< on that rank: MODEL.BODY.hdf of each of several bodies
  Access access_;
  File file_;
};

}  // namespace ritz::format
