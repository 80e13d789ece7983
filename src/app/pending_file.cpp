#include "ritz/app/pending_file.hpp"

#include <fstream>
#include <system_error>

#include "ritz/base/error.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::app {

PendingFile::PendingFile(MPI_Comm comm, const std::filesystem::path& path)
    : comm_(comm), path_(path), part_(path.string() + ".part") {}

PendingFile::~PendingFile() {
  std::error_code ignored;
  if (!published_) std::filesystem::remove(part_, ignored);
}

void PendingFile::write(const std::string& text) const {
  parallel::on_root(comm_, [&] {
    std::ofstream out(part_, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw NumericalError("cannot write " + path_.string() + ": is the disk full? Make room and run again");
  });
}

void PendingFile::publish() {
  parallel::on_root(comm_, [&] {
    std::error_code error;
    std::filesystem::rename(part_, path_, error);
    if (error) throw InputError("cannot write " + path_.string() + ": " + error.message());
  });
  published_ = true;
}

}  // namespace ritz::app
