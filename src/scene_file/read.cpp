// The keys of a scene file and what they mean.
#include <algorithm>
#include <fstream>
#include <memory>
#include <sstream>

#include "entry.hpp"
#include "read.hpp"
#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/printable.hpp"
#include "ritz/base/regular_file.hpp"

namespace ritz::scene {
namespace {

constexpr double max_steps = 1e12;

Integrator integrator(const Entry& entry) {
  const std::string name = text(entry);
  const auto at = std::find(integrator_names.begin(), integrator_names.end(), name);
  if (at == integrator_names.end())
    fail(entry, "unknown integrator '" + printable(name) + "'" + hint(name, integrator_names));
  return static_cast<Integrator>(at - integrator_names.begin());
}

Time time(const Entry& entry) {
  const Section section(entry, {"step", "end", "integrator"});
  Time time{.step = positive(section.get("step")), .end = number(section.get("end")), .integrator = std::nullopt};
  if (time.end < time.step) fail(section.get("end"), "'end' of [time] must not be less than 'step'");
  if (time.end / time.step > max_steps) fail(section.get("step"), "'step' of [time] makes more than 1e12 steps");
  if (const auto name = section.find("integrator")) time.integrator = integrator(*name);
  return time;
}

Static statics(const Entry& entry) {
  const Entry steps = Section(entry, {"steps"}).get("steps");
  const auto count = integer(steps);
  if (count < 1 || count > 1'000'000) fail(steps, steps.name + " must be from 1 to 1000000");
  return {static_cast<int>(count)};
}

std::variant<Time, Static> analysis(const Section& scene) {
  const auto kind = scene.one_of({"time", "static"});
  if (kind == "time") return time({scene.get("time").node, scene.entry().file, "[time]"});
  if (kind == "static") return statics({scene.get("static").node, scene.entry().file, "[static]"});
  throw InputError(scene.entry().file + ": the scene needs [time] (step, end) or [static] (steps)");
}

std::filesystem::path beside(const Section& section, const Entry& name) {
  if (text(name).empty()) fail(name, name.name + " must name a file");
  return std::filesystem::path(section.entry().file).parent_path() / text(name);
}

StoredStart stored_start(const Section& section) {
  StoredStart start{.motion = beside(section, section.get("motion")), .time = {}, .model = {}};
  if (const auto time = section.find("time")) start.time = not_negative(*time);
  if (const auto model = section.find("model")) start.model = beside(section, *model);
  return start;
}

Initial initial(const Entry& entry, const std::string& name, const Section& scene) {
  const Section section({entry.node, entry.file, name}, {"static", "z", "velocity", "motion", "time", "model"});
  if (!scene.find("time")) fail(entry, name + " needs [time]: statics start from the body at rest");
  const auto kind = section.one_of({"static", section.find("z") ? "z" : "velocity", "motion"});
  for (const auto* key : {"time", "model"})
    if (const auto of_motion = section.find(key); of_motion && kind != "motion")
      fail(*of_motion, of_motion->name + " says more of a 'motion', and none is named");
  if (kind == "motion") return stored_start(section);
  if (kind == "static") {
    const Entry asked = section.get("static");
    if (asked.node.value_exact<bool>() != true)
      fail(asked, asked.name + " must be true: a motion that starts undeformed has no " + name);
    return StaticStart{};
  }
  if (kind.empty()) fail(entry, name + " needs one of 'static', 'z', 'velocity' and 'motion'");
  CoordinateStart start;
  if (const auto z = section.find("z")) start.z = numbers(*z);
  if (const auto velocity = section.find("velocity")) start.velocity = numbers(*velocity);
  return start;
}

Damping damping(const Entry& entry) {
  const Section section({entry.node, entry.file, "[damping]"}, {"alpha", "beta", "ratio"});
  Damping damping;
  if (const auto alpha = section.find("alpha")) damping.alpha = not_negative(*alpha);
  if (const auto beta = section.find("beta")) damping.beta = not_negative(*beta);
  if (const auto ratio = section.find("ratio")) {
    if (ratio->node.is_array()) {
      damping.ratio = numbers(*ratio);
      for (const double value : damping.ratio)
        if (value < 0) fail(*ratio, ratio->name + " must not be negative");
    } else {
      damping.ratio = {not_negative(*ratio)};
    }
  }
  return damping;
}

Target target(const Section& section) {
  const auto key = section.one_of({"set", "vertex"});
  if (key == "set") return text(section.get("set"));
  if (key == "vertex") return integer(section.get("vertex"));
  fail(section.entry(), section.entry().name + " needs a 'set' or a 'vertex'");
}

/// Of bodies, as of probes, whose names head columns and name files.
void check_name(const Entry& entry, const std::string& name, const std::string& use) {
  const auto unfit = [](unsigned char c) { return c == ',' || c == '"' || c < ' ' || c == 0x7f; };
  if (name.empty() || std::any_of(name.begin(), name.end(), unfit) || printable(name) != name)
    fail(entry, entry.name + " " + use + ": it must not be empty nor hold a comma, a quote or a control character");
}

/// Relative paths count from the scene file's folder.
Body body(const Section& section, const std::vector<Body>& earlier, const Section& scene) {
  const Entry name = section.get("name");
  Body body{.name = text(name), .model = {}, .model_body = {}};
  check_name(name, body.name, "names files");
  for (const auto& other : earlier)
    if (other.name == body.name) fail(name, "two bodies are named '" + printable(body.name) + "'");
  if (const auto model = section.find("model")) body.model = beside(section, *model);
  if (const auto start = section.find("initial")) body.initial = initial(*start, start->name, scene);
  if (const auto stored = section.find("model_body")) {
    body.model_body = text(*stored);
    if (body.model_body.empty()) fail(*stored, stored->name + " must name a body of the model file");
  }
  return body;
}

/// Whom a load or a probe means. Of one body it need not be said.
std::string whose(const Section& section, const std::vector<Body>& bodies) {
  const auto entry = section.find("body");
  if (!entry && bodies.size() > 1)
    fail(section.entry(), section.entry().name + " needs the key 'body', since the scene has several");
  if (!entry) return bodies.empty() ? "" : bodies.front().name;
  const auto name = text(*entry);
  if (bodies.empty()) fail(*entry, entry->name + " names a body, and the scene has no [[body]]");
  std::vector<std::string> known;
  for (const auto& body : bodies) known.push_back(body.name);
  if (std::ranges::find(known, name) == known.end())
    fail(*entry, "the scene has no body '" + printable(name) + "'" +
                     hint(name, known, [](const std::string& body) { return "'" + printable(body) + "'"; }));
  return name;
}

Load load(const Section& section, const std::vector<Body>& bodies) {
  const auto key = section.one_of({"total", "each", "pressure", "traction"});
  if (key.empty()) fail(section.entry(), "[[load]] needs one of 'total', 'each', 'pressure' and 'traction'");
  const Entry value = section.get(key);
  Load load{.target = target(section), .kind = TotalForce{}, .table = std::nullopt, .body = whose(section, bodies)};
  if (std::holds_alternative<std::int64_t>(load.target) && (key == "pressure" || key == "traction"))
    fail(value, value.name + " acts on a surface set, not on a vertex");
  if (key == "total") load.kind = TotalForce{vector3(value)};
  if (key == "each") load.kind = EachForce{vector3(value)};
  if (key == "pressure") load.kind = Pressure{number(value)};
  if (key == "traction") load.kind = Traction{vector3(value)};
  if (const auto factors = section.find("table")) load.table = table(*factors);
  return load;
}

Quantity quantity(const Entry& entry) {
  const std::string name = text(entry);
  const auto at = std::find(quantity_names.begin(), quantity_names.end(), name);
  if (at == quantity_names.end())
    fail(entry, "unknown quantity '" + printable(name) + "'" + hint(name, quantity_names));
  return static_cast<Quantity>(at - quantity_names.begin());
}

/// One, or a list of them.
std::vector<Quantity> quantities(const Entry& entry) {
  const auto* list = entry.node.as_array();
  if (list == nullptr) return {quantity(entry)};
  std::vector<Quantity> all;
  for (const auto& item : *list) {
    const Entry one{item, entry.file, entry.name};
    all.push_back(quantity(one));
    if (std::count(all.begin(), all.end(), all.back()) > 1) fail(one, entry.name + " names a quantity twice");
  }
  if (all.empty()) fail(entry, entry.name + " is empty: name what is measured, or leave it out");
  return all;
}

Probe probe(const Section& section, const std::vector<Body>& bodies, const Section& scene,
            const std::vector<Probe>& earlier) {
  const Entry name = section.get("name");
  Probe probe{.name = text(name), .target = target(section), .body = whose(section, bodies)};
  check_name(name, probe.name, "heads a column");
  if (const auto asked = section.find("quantity")) {
    probe.quantities = quantities(*asked);
    if (!scene.find("time") && probe.quantities != std::vector{Quantity::displacement})
      fail(*asked, asked->name + " must be \"displacement\" in statics, where nothing moves");
  }
  for (const auto& other : earlier)
    if (other.name == probe.name) fail(name, "two probes are named '" + printable(probe.name) + "'");
  return probe;
}

Vector3 direction(const Entry& entry) {
  const Vector3 d = vector3(entry);
  if (d == Vector3{0, 0, 0}) fail(entry, entry.name + " has no length: give the axis along which the ground moves");
  return d;
}

Scene scene(const Section& file) {
  Scene scene{.analysis = analysis(file), .damping = {}, .gravity = {}, .shake = {}, .loads = {}, .probes = {}};
  if (const auto entry = file.find("damping")) scene.damping = damping(*entry);
  if (const auto entry = file.find("gravity")) scene.gravity = vector3(*entry);
  if (const auto entry = file.find("shake")) {
    if (std::holds_alternative<Static>(scene.analysis)) fail(*entry, "[shake] needs [time]: nothing shakes in statics");
    const Section shake({entry->node, entry->file, "[shake]"}, {"direction", "table"});
    scene.shake = {direction(shake.get("direction")), table(shake.get("table"))};
  }
  if (const auto entry = file.find("initial")) scene.initial = initial(*entry, "[initial]", file);
  for (const auto& section : sections(file, "body", {"name", "model", "model_body", "initial"}))
    scene.bodies.push_back(body(section, scene.bodies, file));
  for (const auto& section :
       sections(file, "load", {"body", "set", "vertex", "total", "each", "pressure", "traction", "table"}))
    scene.loads.push_back(load(section, scene.bodies));
  for (const auto& section : sections(file, "probe", {"name", "body", "set", "vertex", "quantity"}))
    scene.probes.push_back(probe(section, scene.bodies, file, scene.probes));
  return scene;
}

Scene scene_of(const toml::table& root, const std::string& file) {
  return scene(Section({root, file, "the scene"},
                       {"time", "static", "damping", "gravity", "shake", "initial", "body", "load", "probe"}));
}

/// Makes nodes of TOML from values.
struct ToToml {
  using Node = std::unique_ptr<toml::node>;

  template <class Plain>
  Node operator()(const Plain& plain) const {
    return std::make_unique<toml::value<Plain>>(plain);
  }
  Node operator()(const Value::Array& items) const {
    auto array = std::make_unique<toml::array>();
    for (const auto& item : items) array->push_back(*std::visit(*this, item.is));
    return array;
  }
  Node operator()(const Value::Table& entries) const {
    auto table = std::make_unique<toml::table>();
    for (const auto& [key, value] : entries) table->insert_or_assign(key, *std::visit(*this, value.is));
    return table;
  }
};

std::string content(const std::filesystem::path& path) {
  refuse_irregular(path, "the scene file " + path.string());
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  if (!in || !(bytes << in.rdbuf() || in.peek() == EOF))
    throw InputError("cannot read the scene file " + path.string() + ": check the path and its permissions");
  return bytes.str();
}

}  // namespace

Scene read(const std::filesystem::path& path) { return parse(content(path), path.string()); }

Scene parse(const std::string& bytes, const std::string& file) {
  refuse_deep_keys(bytes, file);
  try {
    return scene_of(toml::parse(bytes, file), file);
  } catch (const toml::parse_error& error) {
    throw InputError(file + ":" + std::to_string(error.source().begin.line) +
                     ": not valid TOML: " + printable(error.description()));
  }
}

Scene from_table(const Value::Table& table, const std::string& name) {
  return scene_of(*ToToml()(table)->as_table(), name);
}

}  // namespace ritz::scene
