#include "ritz/algebra/speed.hpp"

#include <petscsys.h>

#include <petscblaslapack.h>  // does not stand alone

#include <algorithm>
#include <chrono>
#include <numeric>
#include <vector>

#include "ritz/algebra/panel.hpp"

namespace ritz::algebra {
namespace {

template <class Work>
double best_seconds(Work work) {
  double best = 1e300;
  for (int repetition = 0; repetition < 3; ++repetition) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

}  // namespace

double dgemm_rate() {
  const PetscBLASInt n = 512;
  const double one = 1, zero = 0;
  const std::vector<double> a(static_cast<std::size_t>(n) * n, 1.0), b(a);
  std::vector<double> c(a.size());
  const double seconds =
      best_seconds([&] { BLASgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &zero, c.data(), &n); });
  return 2.0 * n * n * n / seconds;
}

double memory_rate() {
  const std::vector<double> values(8'000'000, 1.0);
  volatile double sum = 0;
  const double seconds = best_seconds([&] { sum = std::reduce(values.begin(), values.end()); });
  return 8.0 * static_cast<double>(values.size()) / seconds;
}

double panel_seconds(Mat A) {
  PanelProduct product(A);
  Panel x = Panel::Ones(product.rows(), panel_width), y;
  return best_seconds([&] { product.apply(x, y); });
}

}  // namespace ritz::algebra
