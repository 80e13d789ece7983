#include "ritz/format/writer.hpp"

#include <array>
#include <exception>
#include <string>
#include <system_error>

#include "collective.hpp"
#include "disk.hpp"
#include "ritz/base/error.hpp"
#include "vtkhdf.hpp"
#include "write.hpp"

namespace ritz::format {

namespace {

// HDF5 hangs (MPI) or crashes at exit (serial) when the disk is full while it flushes or closes a file. So it must not
// be: room for its own records is taken at the start, and released by emptying the file before one is given up; room
// for a dataset is taken before it is made.
constexpr std::uint64_t room_for_records = 1 << 20;

/// HDF5 1.10's file layout: compact groups, and checksums on everything that is not a dataset's numbers.
Properties file_access(hid_t callers) {
  Properties access(callers == H5P_DEFAULT ? H5Pcreate(H5P_FILE_ACCESS) : H5Pcopy(callers));
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
  return access;
}

}  // namespace

ModelWriter::ModelWriter(Uncreated, std::filesystem::path path, Access access)
    : path_(std::move(path)), access_(std::move(access)) {}

ModelWriter::ModelWriter(std::filesystem::path path, Access access)
    : ModelWriter(Uncreated{}, std::move(path), std::move(access)) {
  create_part();
  reserve_on_disk(room_for_records);  // before there is anything to close

  const Quiet quiet;
  const Properties creation(H5Pcreate(H5P_FILE_CREATE));
  H5Pset_obj_track_times(creation.get(), false);
  H5Pset_link_creation_order(creation.get(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  file_ = File(H5Fcreate(part_.c_str(), H5F_ACC_TRUNC, creation.get(), file_access(access_.file).get()));
  agree(*this, bool(file_), "/");
  make_room(0);
  write_attribute(*this, "/", schema::format, schema::format_name);
  const auto [major, minor] = schema::usual;
  write_attribute(*this, "/", schema::version, std::array<std::int64_t, 2>{major, minor});
}

void ModelWriter::create_part() {
  enum Outcome : std::uint64_t { fine, input, numerical };
  std::uint64_t outcome = fine;
  std::string text;
  if (access_.writes_small) {
    try {
      text = part_file_.emplace(path_).part().string();
    } catch (const InputError& error) {
      outcome = input;
      text = error.what();
    } catch (const std::exception& error) {
      outcome = numerical;
      text = error.what();
    }
  }
  outcome = shared(access_, outcome);
  text = shared(access_, text);
  if (outcome == input) throw InputError(text);
  if (outcome == numerical) throw NumericalError(text);
  part_ = text;
}

void ModelWriter::reserve_on_disk(std::uint64_t bytes) const {
  on_writer(*this, [&] {
    if (const int error = reserve(part_, bytes)) files::fail_to_write(path_, error);
  });
}

void ModelWriter::make_room(std::uint64_t more) const {
  // Not H5Fget_filesize, which fails on a file that MPI has written to.
  std::error_code ignored;
  const std::uint64_t bytes = access_.writes_small ? std::filesystem::file_size(part_, ignored) : 0;
  reserve_on_disk(bytes + more + room_for_records);
}

ModelWriter::~ModelWriter() {
  if (part_.empty()) return;
  const Quiet quiet;
  std::error_code ignored;
  if (access_.writes_small) std::filesystem::resize_file(part_, 0, ignored);
  const bool alone = vote(access_, false) == Vote::alone;  // and no rank closes before there is room
  if (alone) file_.release();
  else file_.close();
  if (alone) std::filesystem::remove(part_, ignored);
}

void ModelWriter::finish() {
  if (!file_) return;
  const Quiet quiet;
  make_room(0);
  const auto bodies = body_links(*this);
  agree(*this, H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) >= 0, "/");
  agree(*this, file_.close(), "/");
  on_writer(*this, [&] {
    release_room(part_);
    part_file_->finish();
    if (bodies.size() == 1) return;
    for (const auto& body : bodies)
      views_.push_back(view_file(path_, body, body == bodies.front() ? "" : schema::join(schema::bodies, body)));
  });
}

void ModelWriter::commit() {
  finish();
  on_writer(*this, [&] {
    part_file_->publish();
    link_beside(path_);
    for (auto& view : views_) view.publish();
  });
  part_.clear();
}

#ifdef H5_HAVE_PARALLEL
ParallelLists::ParallelLists(MPI_Comm comm) : file(H5Pcreate(H5P_FILE_ACCESS)), transfer(H5Pcreate(H5P_DATASET_XFER)) {
  H5Pset_fapl_mpio(file.get(), comm, MPI_INFO_NULL);
  H5Pset_dxpl_mpio(transfer.get(), H5FD_MPIO_COLLECTIVE);
}
#endif

}  // namespace ritz::format
