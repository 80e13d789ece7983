#include "ritz/parallel/ranked_text.hpp"

#include <array>
#include <cerrno>
#include <charconv>

#include "ritz/files/part_file.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"

namespace ritz::parallel {
namespace {

constexpr std::size_t piece = 1 << 24;  ///< bytes in one message

}  // namespace

RankedText::RankedText(MPI_Comm comm, const std::filesystem::path& path) : comm_(comm), path_(path) {
  if (rank(comm) == 0) file_.open(path, std::ios::binary);
}

void RankedText::header(const std::string& text) {
  if (rank(comm_) == 0) append(text);
}

void RankedText::add(double value, char after) {
  std::array<char, 32> digits;
  char* end = std::to_chars(digits.data(), digits.data() + digits.size() - 1, value).ptr;
  *end++ = after;
  append({digits.data(), end});
}

void RankedText::append(std::string_view text) {
  text_ += text;
  if (text_.size() >= piece) rank(comm_) == 0 ? flush() : send();
}

void RankedText::end_part() {
  if (rank(comm_) == 0) {
    flush();
    for (int p = 1; p < size(comm_); ++p)
      while (receive(p)) {
      }
    return;
  }
  if (!text_.empty()) send();
  send();  // nothing: the end
}

void RankedText::close() {
  on_root(comm_, [&] {
    flush();
    errno = 0;
    file_.close();
    if (!file_) files::fail_to_write(path_, error_ != 0 ? error_ : errno);
  });
}

void RankedText::flush() {
  errno = 0;
  if (!(file_ << text_ << std::flush) && error_ == 0) error_ = errno;
  text_.clear();
}

void RankedText::send() {
  MPI_Send(text_.data(), static_cast<int>(text_.size()), MPI_CHAR, 0, 0, comm_);
  text_.clear();
}

bool RankedText::receive(int from) {
  MPI_Status status;
  int length = 0;
  MPI_Probe(from, 0, comm_, &status);
  MPI_Get_count(&status, MPI_CHAR, &length);
  text_.resize(static_cast<std::size_t>(length));
  MPI_Recv(text_.data(), length, MPI_CHAR, from, 0, comm_, MPI_STATUS_IGNORE);
  flush();
  return length > 0;
}

}  // namespace ritz::parallel
