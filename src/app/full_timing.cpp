#include "ritz/app/full_timing.hpp"

#include <sstream>

namespace ritz::app {

void FullTiming::begin_step() { begin_ = std::chrono::steady_clock::now(); }

void FullTiming::end_step(double t, const Effort& so_far) {
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin_;
  std::ostringstream row;
  row.precision(15);
  row << t << ',' << took.count() << ',' << so_far.iterations - before_.iterations << ','
      << so_far.rejected - before_.rejected << '\n';
  rows_ += row.str();
  before_ = so_far;
}

void FullTiming::finish() const {
  file_.write(rows_);
  file_.finish();
}

}  // namespace ritz::app
