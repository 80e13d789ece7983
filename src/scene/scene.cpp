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
  for (const auto& body : scene.bodies)
    if (body.name == name && body.initial) own.initial = body.initial;
  own.bodies.clear();
  const auto acts_elsewhere = [&](const auto& item) { return item.body != name; };
  std::erase_if(own.loads, acts_elsewhere);
  std::erase_if(own.probes, acts_elsewhere);
  return own;
}

std::vector<std::string> probe_columns(const std::vector<Probe>& probes) {
  constexpr std::array<std::string_view, 3> letters = {"u", "v", "a"};
  std::vector<std::string> columns;
  for (const auto& probe : probes)
    for (const auto quantity : probe.quantities)
      for (const auto* axis : {"x", "y", "z"})
        columns.push_back(probe.name + "_" + std::string(letters[static_cast<std::size_t>(quantity)]) + axis);
  return columns;
}

bool any_measures(const std::vector<Probe>& probes, Quantity quantity) {
  return std::ranges::any_of(probes, [&](const Probe& probe) {
    return std::ranges::find(probe.quantities, quantity) != probe.quantities.end();
  });
}

std::int64_t step_count(const Time& time) {
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(time.end / time.step - 1e-9)));
}

double factor(const Scene& scene, const std::optional<Table>& table, double t) {
  if (table) return table->at(t);
  return std::holds_alternative<Static>(scene.analysis) ? t : 1;
}

std::int64_t frame_count(const FrameChoice& choice, std::int64_t steps) {
  return choice.every ? steps / *choice.every + 1 : std::min(choice.frames.value_or(201), steps + 1);
}

std::vector<std::int64_t> frame_schedule(const FrameChoice& choice, std::int64_t steps) {
  std::vector<std::int64_t> states;
  if (choice.every) {
    for (std::int64_t state = 0; state <= steps; state += *choice.every) states.push_back(state);
    return states;
  }
  const std::int64_t frames = frame_count(choice, steps);
  if (frames == 1) return {steps};
  for (std::int64_t i = 0; i < frames; ++i)
    states.push_back(static_cast<std::int64_t>(static_cast<long double>(i) * steps / (frames - 1) + 0.5L));
  return states;
}

}  // namespace ritz::scene
