#include "take.hpp"

#include "ritz/base/printable.hpp"
#include "ritz/readers/file_scene.hpp"
#include "ritz/scene_file/read.hpp"
#include "ritz/scene_file/write.hpp"

namespace ritz::decks {
namespace {

void scale(scene::Vector3& v, double by) {
  for (double& x : v) x *= by;
}

void scale_times(scene::Table& table, double by) {
  for (auto& [t, value] : table.points) t *= by;
}

/// From the deck's units to SI. The tables of statics are over load fractions, which have no unit.
struct ToSi {
  const readers::Units& units;

  double acceleration() const { return units.length / (units.time * units.time); }
  double force() const { return units.mass * acceleration(); }

  void operator()(scene::TotalForce& f) const { scale(f.newton, force()); }
  void operator()(scene::EachForce& f) const { scale(f.newton, force()); }
  void operator()(scene::Pressure& p) const { p.pascal *= units.pressure(); }
  void operator()(scene::Traction& t) const { scale(t.pascal, units.pressure()); }

  void operator()(scene::Scene& scene) const {
    auto* const time = std::get_if<scene::Time>(&scene.analysis);
    if (time) time->step *= units.time, time->end *= units.time;
    if (scene.gravity) scale(*scene.gravity, acceleration());
    if (scene.shake) {
      scale(scene.shake->direction, acceleration());
      scale_times(scene.shake->table, units.time);
    }
    for (auto& load : scene.loads) {
      std::visit(*this, load.kind);
      if (load.table && time) scale_times(*load.table, units.time);
    }
  }
};

std::string comment(const std::string& text) { return "# " + printable(text) + "\n"; }

}  // namespace

Taken take(const Options& options) {
  auto file = readers::read_scene(options.deck, options.ignored, options.step);
  ToSi{options.units}(file.scene);
  const auto scene = scene::written(file.scene);
  scene::parse(scene, "the scene of " + options.deck.string());  // what is written can be read
  std::string head =
      comment("The loads of " + options.deck.string() + ", " + file.step + ", in SI units; those of the deck are " +
              options.units.name + " (-units of ritz-reduce and ritz-full).");
  for (const auto& note : file.notes) head += comment(note);
  return {.text = head + scene, .notes = std::move(file.notes), .files = std::move(file.files)};
}

}  // namespace ritz::decks
