#include "ritz/app/pending_file.hpp"

#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {

PendingFile::PendingFile(MPI_Comm comm, const std::filesystem::path& path) : comm_(comm) {
  std::string part;
  parallel::on_root(comm, [&] { part = file_.emplace(path).part().string(); });
  parallel::broadcast(comm, part);
  part_ = part;
}

void PendingFile::write(const std::string& text) const {
  parallel::on_root(comm_, [&] { file_->write(text); });
}

void PendingFile::finish() const {
  parallel::on_root(comm_, [&] { file_->finish(); });
}

void PendingFile::publish() {
  parallel::on_root(comm_, [&] { file_->publish(); });
}

}  // namespace ritz::app
