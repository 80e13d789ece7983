// The scene of a step of a deck.
#include "ritz/readers/inp_scene.hpp"

#include <algorithm>
#include <cmath>

#include "ritz/base/error.hpp"
#include "ritz/base/set_name.hpp"

namespace ritz::readers {

namespace {

/// A keyword of which no scene is made, and what is said of it.
struct Beside {
  std::string_view keyword;
  std::string_view what;
};

constexpr Beside damping[] = {
    {"DAMPING", "*DAMPING is not in the scene; [damping] has alpha and beta of the body"},
    {"MODALDAMPING", "*MODAL DAMPING is not in the scene; [damping] has ratios of the modes, alpha and beta"},
    {"GLOBALDAMPING", "*GLOBAL DAMPING is not in the scene; [damping] has alpha and beta"}};

constexpr std::string_view heating[] = {"CFLUX", "DFLUX", "DSFLUX", "FILM", "SFILM", "RADIATE", "SRADIATE"};

double magnitude_of(const Sources& sources, const InpLoad& load) {
  if (load.fields.size() < 3 || load.fields[2].text.empty())
    fail(sources, load.fields[0].place, "a load needs a magnitude after its type");
  return inp_number(sources, load.fields, 2, "a magnitude");
}

void refuse_more(const Sources& sources, const InpLoad& load, std::size_t most) {
  for (std::size_t i = most; i < load.fields.size(); ++i)
    if (!load.fields[i].text.empty()) fail(sources, load.fields[i].place, "this load has more fields than expected");
}

scene::Vector3 times(double factor, scene::Vector3 v) {
  for (double& x : v) x *= factor;
  return v;
}

void add(scene::Vector3& to, const scene::Vector3& v) {
  for (std::size_t i = 0; i < 3; ++i) to[i] += v[i];
}

/// Gravity of one table: of each cell of the mesh.
struct Gravity {
  std::optional<scene::Table> table;
  std::vector<scene::Vector3> of_cells;
  Place place;
};

struct Maker {
  const Sources& sources;
  InpModel& model;
  const InpAnalysis& analysis;
  std::vector<Gravity> gravities = {};
  scene::Scene scene = {
      .analysis = scene::Static{1}, .damping = {}, .gravity = {}, .shake = {}, .bodies = {}, .loads = {}, .probes = {}};
};

// The set has the name of the finished mesh, or it is one vertex.
scene::Target target_of(const InpModel& model, const InpActing& acting) {
  if (acting.vertex) return *acting.vertex;
  return model.mesh.sets[model.set_index.at(acting.set)].name;
}

/// Whether a load is of no size, as one that takes back a load of an earlier step.
struct IsNothing {
  bool operator()(const scene::TotalForce& f) const { return f.newton == scene::Vector3{}; }
  bool operator()(const scene::EachForce& f) const { return f.newton == scene::Vector3{}; }
  bool operator()(const scene::Pressure& p) const { return p.pascal == 0; }
  bool operator()(const scene::Traction& t) const { return t.pascal == scene::Vector3{}; }
};

bool is_force(const scene::Load& load) { return std::holds_alternative<scene::EachForce>(load.kind); }

// The components of a force stand in a line each.
void add_force(Maker& make, const InpActing& acting) {
  const auto& load = *acting.load;
  refuse_more(make.sources, load, 3);
  const double magnitude = magnitude_of(make.sources, load);
  scene::EachForce force{};
  force.newton[static_cast<std::size_t>(acting.on.front() % 3)] = magnitude;
  const auto table = inp_factor(make.sources, make.model, make.analysis, acting, magnitude);
  const auto target = target_of(make.model, acting);
  auto& loads = make.scene.loads;
  if (!loads.empty() && is_force(loads.back()) && loads.back().target == target && loads.back().table == table)
    add(std::get<scene::EachForce>(loads.back().kind).newton, force.newton);
  else loads.push_back({.target = target, .kind = force, .table = table});
}

/// A load of `numbers` data fields on a surface; kind(magnitude) is what a scene calls it. `word` and `note` say what
/// NLGEOM would make of it.
template <class Kind>
void add_on_surface(Maker& make, const InpActing& acting, std::size_t numbers, Kind kind, const std::string& word,
                    const std::string& note) {
  refuse_more(make.sources, *acting.load, numbers);
  const double magnitude = magnitude_of(make.sources, *acting.load);
  make.scene.loads.push_back({.target = target_of(make.model, acting),
                              .kind = kind(magnitude),
                              .table = inp_factor(make.sources, make.model, make.analysis, acting, magnitude)});
  if (make.model.steps[make.analysis.step].nonlinear && make.model.words.insert(word).second)
    make.model.mesh.notes.push_back(located(make.sources, acting.load->fields[0].place) + note);
}

void add_pressure(Maker& make, const InpActing& acting) {
  add_on_surface(
      make, acting, 3, [](double magnitude) { return scene::Pressure{magnitude}; }, "DEAD PRESSURE",
      "with NLGEOM a pressure follows the surface as it turns; that of a scene keeps the direction that it has on the "
      "body at rest");
}

void add_traction(Maker& make, const InpActing& acting) {
  add_on_surface(
      make, acting, 6,
      [&](double magnitude) { return scene::Traction{times(magnitude, inp_vector(make.sources, *acting.load))}; },
      "DEAD TRACTION",
      "with NLGEOM Abaqus turns a traction with the surface unless FOLLOWER=NO is said; that of a scene keeps its "
      "direction");
}

void add_gravity(Maker& make, const InpActing& acting) {
  refuse_more(make.sources, *acting.load, 6);
  const double magnitude = magnitude_of(make.sources, *acting.load);
  const auto table = inp_factor(make.sources, make.model, make.analysis, acting, magnitude);
  auto& all = make.gravities;
  auto found = std::find_if(all.begin(), all.end(), [&](const Gravity& g) { return g.table == table; });
  if (found == all.end())
    found = all.insert(all.end(), {.table = table,
                                   .of_cells = std::vector<scene::Vector3>(make.model.mesh.shapes.size()),
                                   .place = acting.load->fields[0].place});
  const auto g = times(magnitude, inp_vector(make.sources, *acting.load));
  for (const Index cell : acting.on) add(found->of_cells[static_cast<std::size_t>(cell)], g);
}

// But for the rounding of directions that are written in several ways.
bool same_vector(const scene::Vector3& a, const scene::Vector3& b) {
  const double apart = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  return apart <= 1e-12 * std::hypot(a[0], a[1], a[2]);
}

// That of all solid cells. Throws where they differ.
scene::Vector3 common(Maker& make, const Gravity& gravity) {
  std::optional<scene::Vector3> first;
  for (std::size_t c = 0; c < gravity.of_cells.size(); ++c) {
    if (!make.model.mesh.shapes[c].cell) continue;
    if (first && !same_vector(gravity.of_cells[c], *first))
      fail(
          make.sources, gravity.place,
          "GRAV acts on a part of the body, or differs between its parts: the gravity of a scene is that of the whole");
    first = gravity.of_cells[c];
  }
  return first.value_or(scene::Vector3{});
}

void place_gravity(Maker& make, const Gravity& gravity) {
  auto& scene = make.scene;
  const auto g = common(make, gravity);
  const auto note = [&](const std::string& text) {
    make.model.mesh.notes.push_back(located(make.sources, gravity.place) + text);
  };
  if (!gravity.table || !make.analysis.motion) {
    const double at_end = gravity.table ? gravity.table->at(1) : 1;
    auto all = scene.gravity.value_or(scene::Vector3{});
    add(all, times(at_end, g));
    scene.gravity = all;
    if (gravity.table)
      note("the gravity of the scene grows in proportion to the load fraction; at the end of the step it is this one");
    return;
  }
  if (scene.shake)
    fail(make.sources, gravity.place, "gravity with several amplitudes is not supported: a scene has one shaking");
  scene.shake = scene::Shake{times(-1, g), *gravity.table};
  note("this gravity changes, and so is a shaking of the ground in the scene, which pushes the body alike");
}

void add_load(Maker& make, const InpActing& acting) {
  const auto& keyword = keyword_of(make.model, *acting.load);
  if (acting.step != make.analysis.step && keyword.has("AMPLITUDE"))
    fail(make.sources, acting.load->fields[0].place,
         "this load is in effect in a later step, and what its amplitude then does is not the same in all programs; "
         "let the later step say its loads, with OP=NEW");
  switch (acting.action) {
    case InpAction::force: return add_force(make, acting);
    case InpAction::pressure: return add_pressure(make, acting);
    case InpAction::traction: return add_traction(make, acting);
    case InpAction::gravity: return add_gravity(make, acting);
  }
}

scene::Static statics(const Sources& sources, const InpModel& model, const InpAnalysis& analysis) {
  const double count = std::ceil(analysis.period / analysis.increment - 1e-9);
  if (count > 1e6)
    fail(sources, model.steps[analysis.step].place,
         "this step has more than 1e6 increments, the most that a scene has");
  return {std::max(1, static_cast<int>(count))};
}

// What else in the deck moves the body.
void look_beside(const Sources& sources, InpModel& model, const InpAnalysis& analysis) {
  const auto& passed = model.passed_over;
  const auto note = [&](std::string_view keyword, const std::string& text) {
    if (const auto found = passed.find(std::string(keyword)); found != passed.end())
      model.mesh.notes.push_back(located(sources, found->second) + text);
  };
  for (const auto keyword : heating)
    note(keyword, "*" + std::string(keyword) + " heats the body, which moves nothing in ritz");
  if (model.temperatures)
    model.mesh.notes.push_back(located(sources, *model.temperatures) +
                               "*TEMPERATURE is not in the scene, for materials of ritz do not expand");
  if (!analysis.motion) return;
  for (const auto& [keyword, what] : damping) note(keyword, std::string(what));
  if (const auto found = passed.find("BASEMOTION"); found != passed.end())
    leave_out(sources, found->second, {"BASEMOTION"},
              "*BASE MOTION is not taken into the scene, whose [shake] can say it", model);
  if (model.in_motion)
    leave_out(sources, *model.in_motion, {"INITIALCONDITIONS"},
              "*INITIAL CONDITIONS give the body a motion, and a scene begins at rest", model);
}

std::string called(const Sources& sources, const InpModel& model, std::size_t number) {
  const auto& step = model.steps[number];
  auto where = located(sources, step.place);
  return "step " + std::to_string(number) + " (*" + step.procedure->keyword.title + ") at " +
         where.substr(0, where.size() - 2);
}

}  // namespace

scene::Vector3 inp_vector(const Sources& sources, const InpLoad& load) {
  scene::Vector3 v{};
  for (std::size_t i = 0; i < 3; ++i) v[i] = inp_number(sources, load.fields, 3 + i, "a direction");
  const double length = std::hypot(v[0], v[1], v[2]);
  if (!(length > 0)) fail(sources, load.fields[0].place, "this load needs a direction after its magnitude");
  return times(1 / length, v);
}

FileScene read_scene(const std::filesystem::path& path, const Ignored& ignored, std::optional<int> step) {
  if (upper(path.extension().string()) != ".INP")
    throw InputError(path.string() + ": scenes are made of the decks of Abaqus and CalculiX (.inp) alone");
  Sources sources;
  auto model = read_inp_model(sources, open(sources, path), ignored);
  const auto analysis = inp_analysis(sources, model, step);
  look_beside(sources, model, analysis);
  const auto loads = inp_loads(sources, model, analysis);
  tell_kinds_apart(sources, model.mesh);
  Maker make{.sources = sources, .model = model, .analysis = analysis};
  for (const auto& acting : loads) add_load(make, acting);
  for (const auto& gravity : make.gravities) place_gravity(make, gravity);
  std::erase_if(make.scene.loads, [](const scene::Load& load) { return std::visit(IsNothing{}, load.kind); });
  if (analysis.motion) make.scene.analysis = scene::Time{analysis.increment, analysis.period, std::nullopt};
  else make.scene.analysis = statics(sources, model, analysis);
  if (loads.empty())
    model.mesh.notes.push_back(located(sources, model.steps[analysis.step].place) + "this step has no loads");
  note_idle_words(model);
  std::vector<std::filesystem::path> files;
  for (const auto& source : sources) files.push_back(source.path);
  return {.scene = std::move(make.scene),
          .step = called(sources, model, analysis.step),
          .notes = finish(sources, std::move(model.mesh)).notes,
          .files = std::move(files)};
}

}  // namespace ritz::readers
