#include "run_start.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "ritz/base/error.hpp"
#include "ritz/base/shown.hpp"
#include "ritz/format/checksum.hpp"
#include "ritz/format/motion_reader.hpp"
#include "ritz/format/schema.hpp"

namespace ritz::tools {
namespace {

/// What is said of a scene, with all digits: equal texts mean equal scenes.
class SceneText {
 public:
  explicit SceneText(const scene::Scene& scene) {
    text_.precision(17);
    const auto& time = std::get<scene::Time>(scene.analysis);
    add(time.step, time.integrator ? static_cast<int>(*time.integrator) : -1);
    add(scene.damping.alpha, scene.damping.beta, scene.damping.ratio);
    if (scene.gravity) add("gravity", *scene.gravity);
    if (scene.shake) add("shake", scene.shake->direction, scene.shake->table);
    if (scene.initial) {
      add("initial", scene.initial->index());
      std::visit([this](const auto& start) { add(start); }, *scene.initial);
    }
    for (const auto& load : scene.loads) {
      add("load", load.kind.index());
      std::visit([this](const auto& target) { add(target); }, load.target);
      std::visit([this](const auto& kind) { add(kind); }, load.kind);
      if (load.table) add(*load.table);
    }
  }

  std::string checksum(const RunOptions& options) {
    add(static_cast<int>(options.forces), static_cast<int>(options.precision));
    const auto text = text_.str();
    return formatted("%016llx",
                     static_cast<unsigned long long>(format::checksum(std::as_bytes(std::span(text)), text.size())));
  }

 private:
  template <class... Parts>
  void add(const Parts&... parts) {
    (write(parts), ...);
  }
  template <class Part>
  void write(const Part& part) {
    text_ << part << '\n';
  }
  void write(const std::string& name) { text_ << name.size() << ' ' << name << '\n'; }
  void write(const std::filesystem::path& path) { write(path.string()); }
  void write(const scene::Vector3& vector) { add(vector[0], vector[1], vector[2]); }
  void write(const std::vector<double>& numbers) {
    write(numbers.size());
    for (const double number : numbers) write(number);
  }
  void write(const scene::Table& table) {
    for (const auto& [t, value] : table.points) add(t, value);
  }
  void write(const scene::TotalForce& force) { write(force.newton); }
  void write(const scene::EachForce& force) { write(force.newton); }
  void write(const scene::Pressure& pressure) { write(pressure.pascal); }
  void write(const scene::Traction& traction) { write(traction.pascal); }
  void write(const scene::StaticStart&) {}
  void write(const scene::CoordinateStart& start) { add(start.z, start.velocity); }
  void write(const scene::StoredStart& start) { add(start.motion.filename(), start.time.value_or(-1)); }

  std::ostringstream text_;
};

void refuse_other_model(const format::ReducedMotionReader& in, const RunBody& body) {
  if (in.model_checksum() != body.coordinates)
    throw InputError(in.name() + ": it is the motion of another model than " + body.model_file.string() +
                     ", whose coordinates mean something else");
}

world::GivenStart read_start(const scene::StoredStart& start, const RunBody& body) {
  if (!start.model.empty())
    throw InputError("[initial] names the model " + start.model.string() +
                     " of its motion, which is for ritz-full: ritz-run has its model, so leave it out");
  const format::ReducedMotionReader in(start.motion, "[initial] motion " + start.motion.string());
  refuse_other_model(in, body);
  const auto state = in.state(in.index_at(start.time));
  return {state.col(0), state.col(1)};
}

std::optional<world::EnergyBalance> balance_of(const std::map<std::string, double>& numbers) {
  if (numbers.empty()) return std::nullopt;
  return world::EnergyBalance{.start = numbers.at("start"),
                              .gained = numbers.at("gained"),
                              .lost = numbers.at("lost"),
                              .available = numbers.at("available"),
                              .work = numbers.at("work"),
                              .dissipated = numbers.at("dissipated")};
}

world::Checkpoint read_checkpoint(const RunOptions& options, const RunBody& body) {
  const auto file = motion_of(options.restart, "--restart", body);
  const format::ReducedMotionReader in(file, "--restart " + file.string());
  const auto end = in.end();
  refuse_other_model(in, body);
  if (end.scene_checksum != SceneText(body.scene).checksum(options))
    throw InputError(in.name() +
                     ": it was run under another scene, --single or --linear, and of the same one only 'end' and "
                     "[[probe]] may change; a new scene starts from it by [initial] motion");
  const auto& time = std::get<scene::Time>(body.scene.analysis);
  if (end.steps >= scene::step_count(time))
    throw InputError(in.name() + ": nothing is left to do: its last state, at " +
                     shown(static_cast<double>(end.steps) * time.step) + " s, is the scene's end or later");
  world::Checkpoint from{.steps = end.steps,
                         .history = end.history,
                         .last_dt = end.last_step,
                         .energy = balance_of(end.numbers),
                         .gain = {}};
  if (end.numbers.contains("gain_since"))
    from.gain = {.since = end.numbers.at("gain_since"), .largest = end.numbers.at("gain_largest")};
  return from;
}

}  // namespace

std::filesystem::path motion_of(const std::filesystem::path& all, const std::string& option, const RunBody& body) {
  if (body.name.empty()) return all;
  if (all.filename().empty() || all.filename() == "." || all.filename() == "..")
    throw InputError(option + " " + all.string() +
                     " is a folder: give the name of a file, from which the motions of the "
                     "bodies get theirs");
  const auto ending = all.has_extension() ? all.extension().string() : ".h5";
  return all.parent_path() / (all.stem().string() + "." + format::schema::link_name(body.name) + ending);
}

std::optional<files::Named> stored_start(const RunBody& body) {
  const auto* start = body.scene.initial ? std::get_if<scene::StoredStart>(&*body.scene.initial) : nullptr;
  if (start == nullptr) return std::nullopt;
  return files::Named{"the motion " + start->motion.string() + " of [initial]", start->motion};
}

std::vector<world::Start> starts(const RunOptions& options, const std::vector<RunBody>& bodies) {
  std::vector<world::Start> all;
  for (const auto& body : bodies) {
    world::naming(body.name, [&] {
      if (!options.restart.empty()) {
        if (std::holds_alternative<scene::Static>(body.scene.analysis))
          throw InputError("--restart goes on in time, and the scene is of statics: leave it out");
        all.emplace_back(read_checkpoint(options, body));
      } else if (const auto stored = stored_start(body)) {
        all.emplace_back(read_start(std::get<scene::StoredStart>(*body.scene.initial), body));
      } else {
        all.emplace_back();
      }
      if (steps_behind({all.back()}) != steps_behind(all))
        throw InputError("--restart " + options.restart.string() + ": its bodies did not stop at the same time");
    });
  }
  return all;
}

std::int64_t steps_behind(const std::vector<world::Start>& starts) {
  const auto* from = starts.empty() ? nullptr : std::get_if<world::Checkpoint>(&starts.front());
  return from ? from->steps : 0;
}

format::ReducedState end_of(const RunOptions& options, const RunBody& body, const world::RunResult& result) {
  const auto& last = *result.last;
  format::ReducedState end{.integrator = std::string(result.integrator),
                           .scene_checksum = SceneText(body.scene).checksum(options),
                           .steps = last.steps,
                           .last_step = last.last_dt,
                           .history = last.history,
                           .numbers = {}};
  if (const auto& energy = last.energy)
    end.numbers = {{"start", energy->start},         {"gained", energy->gained}, {"lost", energy->lost},
                   {"available", energy->available}, {"work", energy->work},     {"dissipated", energy->dissipated}};
  if (last.gain) {
    end.numbers["gain_since"] = last.gain->since;
    end.numbers["gain_largest"] = last.gain->largest;
  }
  return end;
}

}  // namespace ritz::tools
