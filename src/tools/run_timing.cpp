#include "run_timing.hpp"

#include <stdexcept>

namespace ritz::tools {

TimingWriter::TimingWriter(const std::filesystem::path& path) : file_(path), out_(file_.part()) {
  out_.precision(15);
  out_ << "t,microseconds,iterations,rejected\n";
}

void TimingWriter::row(const StepCost& step) {
  out_ << step.t << ',' << 1e6 * step.seconds << ',' << step.iterations << ',' << step.rejected << '\n';
}

void TimingWriter::commit() {
  out_.close();
  if (!out_) throw std::runtime_error("could not write all of " + file_.path().string() + ": is the disk full?");
  file_.commit();
}

}  // namespace ritz::tools
