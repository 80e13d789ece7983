#include "run_timing.hpp"

namespace ritz::tools {

TimingWriter::TimingWriter(const std::filesystem::path& path) : table_(path) {
  table_.out() << "t,microseconds,iterations,rejected\n";
}

void TimingWriter::row(const world::StepCost& step) {
  table_.out() << step.t << ',' << 1e6 * step.seconds << ',' << step.iterations << ',' << step.rejected << '\n';
  table_.check();
}

}  // namespace ritz::tools
