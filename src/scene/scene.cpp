#include "ritz/scene/scene.hpp"

#include <algorithm>
#include <cmath>

namespace ritz::scene {

double Table::at(double t) const {
  const auto after = std::upper_bound(points.begin(), points.end(), t, [](double x, auto& p) { return x < p.first; });
  if (after == points.begin()) return points.front().second;
  if (after == points.end()) return points.back().second;
  const auto [t0, v0] = after[-1];
  const auto [t1, v1] = *after;
  return v0 + (v1 - v0) * ((t - t0) / (t1 - t0));
}

Scene of_body(const Scene& scene, std::string_view name) {
  Scene own = scene;
  own.bodies.clear();
  const auto acts_elsewhere = [&](const auto& item) { return item.body != name; };
  std::erase_if(own.loads, acts_elsewhere);
  std::erase_if(own.probes, acts_elsewhere);
  return own;
}

std::int64_t step_count(const Time& time) {
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(time.end / time.step - 1e-9)));
}

double factor(const Scene& scene, const std::optional<Table>& table, double t) {
  if (table) return table->at(t);
  return std::holds_alternative<Static>(scene.analysis) ? t : 1;
}

}  // namespace ritz::scene
