// The step of a deck whose scene is made, and its procedure.
#include <algorithm>

#include "ritz/readers/inp_scene.hpp"

namespace ritz::readers {

namespace {

bool has_scene(const InpStep& step) {
  if (!step.procedure) return false;
  const auto& name = step.procedure->keyword.name;
  return name == "STATIC" || name == "DYNAMIC" || name == "MODALDYNAMIC";
}

std::size_t asked_step(const Sources& sources, const InpModel& model, std::optional<int> number) {
  const auto& steps = model.steps;
  if (!number) {
    const auto last = std::find_if(steps.rbegin(), steps.rend(), has_scene);
    if (last == steps.rend())
      fail(sources, "no step of the deck is *STATIC, *DYNAMIC or *MODAL DYNAMIC, which alone make a scene");
    return static_cast<std::size_t>(steps.rend() - last) - 1;
  }
  if (*number < 1 || *number >= std::ssize(steps))
    fail(sources, "the deck has no step " + std::to_string(*number) + "; it has " + std::to_string(steps.size() - 1));
  const auto& step = steps[static_cast<std::size_t>(*number)];
  if (!has_scene(step))
    fail(sources, step.place,
         "step " + std::to_string(*number) + " is not *STATIC, *DYNAMIC or *MODAL DYNAMIC, which alone make a scene");
  return static_cast<std::size_t>(*number);
}

/// Of the data line of a procedure, in the deck's time; 0 where it is blank.
struct Times {
  double increment, period;
};

Times times_of(const Sources& sources, const InpLines& procedure) {
  if (procedure.lines.empty()) return {0, 0};
  const auto parts = fields(procedure.lines.front());
  const Times times{inp_number(sources, parts, 0, "the first increment"), inp_number(sources, parts, 1, "the period")};
  if (times.increment < 0 || times.period < 0)
    fail(sources, procedure.lines.front().place, "times of *" + procedure.keyword.title + " must not be negative");
  return times;
}

void read_static_times(InpAnalysis& analysis) {
  if (analysis.period == 0) analysis.period = 1;
  if (analysis.increment == 0 || analysis.increment > analysis.period) analysis.increment = analysis.period;
}

void check_motion_times(const Sources& sources, const InpLines& procedure, const InpAnalysis& analysis) {
  if (analysis.increment > 0 && analysis.period >= analysis.increment) return;
  fail(sources, procedure.keyword.place,
       "*" + procedure.keyword.title +
           " needs a time increment, which becomes the step of the scene, and a period that is not less, in its line");
}

// The time of the steps before, which TIME=TOTAL TIME counts; nothing where not all of them are over time.
std::optional<double> time_before(const Sources& sources, const InpModel& model, std::size_t step) {
  double time = 0;
  for (std::size_t s = 1; s < step; ++s) {
    if (!has_scene(model.steps[s])) return std::nullopt;
    const double period = times_of(sources, *model.steps[s].procedure).period;
    time += period == 0 && model.steps[s].procedure->keyword.name == "STATIC" ? 1 : period;
  }
  return time;
}

bool is_ramped(const Sources& sources, const InpStep& step, bool motion) {
  const auto& procedure = step.procedure->keyword;
  const auto usual = motion && upper(procedure.value("APPLICATION").value_or("")) != "QUASI-STATIC" ? "STEP" : "RAMP";
  const auto said = upper(step.keyword->value("AMPLITUDE").value_or(usual));
  if (said != "STEP" && said != "RAMP")
    fail(sources, step.place, "*STEP has AMPLITUDE=STEP and AMPLITUDE=RAMP, not AMPLITUDE='" + said + "'");
  return said == "RAMP";
}

void refuse_procedure(const Sources& sources, InpModel& model, const Keyword& procedure) {
  constexpr std::string_view other[] = {"RIKS", "STEADYSTATE", "CONTINUE", "LOADCASE"};
  for (const auto word : other)
    if (procedure.has(word))
      fail(sources, procedure.place, "*" + procedure.title + " with " + std::string(word) + " is no scene of ritz");
  constexpr std::string_view silent[] = {"DIRECT", "SOLVER", "APPLICATION"};
  for (const auto& [name, value] : procedure.parameters)
    if (std::find(std::begin(silent), std::end(silent), name) == std::end(silent))
      model.mesh.notes.push_back(located(sources, procedure.place) + "'" + name + "' of *" + procedure.title +
                                 " is not in the scene");
}

// Where the step begins: the steps before have left the body as it was, or it is statics, of which the end counts.
void refuse_history(const Sources& sources, const InpModel& model, const InpAnalysis& analysis) {
  const auto& step = model.steps[analysis.step];
  for (std::size_t s = 1; s < analysis.step; ++s) {
    const auto& earlier = model.steps[s];
    if (!earlier.loaded) continue;
    const auto which = "step " + std::to_string(s);
    if (analysis.motion || step.preloaded)
      fail(sources, step.place,
           "this step begins where " + which +
               ", which has loads, leaves the body, and a scene begins at rest; take the scene of another step");
    if (!has_scene(earlier) || earlier.procedure->keyword.name != "STATIC" || earlier.preloaded)
      fail(sources, earlier.place,
           "what the loads of " + which +
               ", which is not an ordinary *STATIC step, leave for later steps is not clear; take the scene of an "
               "earlier step");
  }
}

void refuse_fixed(const Sources& sources, InpModel& model, const InpAnalysis& analysis) {
  bool loaded = false;
  for (std::size_t s = 1; s <= analysis.step; ++s) {
    if (loaded && model.steps[s].fixed)
      leave_out(
          sources, *model.steps[s].fixed, "BOUNDARY",
          "*BOUNDARY, FIXED holds nodes where the loads of an earlier step left them, and a scene holds them where "
          "they are at rest",
          model.ignored, model.mesh);
    loaded = loaded || model.steps[s].loaded;
  }
}

void note_way(const Sources& sources, InpModel& model, const InpAnalysis& analysis) {
  const auto& step = model.steps[analysis.step];
  const auto& keyword = step.procedure->keyword;
  const auto note = [&](const std::string& text) { model.mesh.notes.push_back(located(sources, step.place) + text); };
  if (analysis.motion && keyword.name == "DYNAMIC" && !keyword.has("DIRECT"))
    note("the increments of this step adapt themselves; the scene has the first one throughout");
  if (!step.nonlinear && keyword.name != "MODALDYNAMIC")
    note(
        "this step is linear (no NLGEOM); ritz-full and models with a polynomial have large displacements, ritz-run "
        "--linear has not, and all agree while displacements are small");
  for (std::size_t s = 1; s < analysis.step; ++s)
    if (model.steps[s].loaded) {
      note(
          "loads of earlier steps that are still in effect grow from nothing with those of this step: the end of the "
          "scene is that of the step, and the way there another");
      return;
    }
}

// The supports are those of the mesh, which are those of one step.
void note_supports(const Sources& sources, InpModel& model, const InpAnalysis& analysis) {
  const auto& step = model.steps[analysis.step];
  if (analysis.step == model.supported_step) return;
  if (step.moved)
    leave_out(sources, *step.moved, "BOUNDARY", "a prescribed displacement other than zero is no load that a scene has",
              model.ignored, model.mesh);
  const auto& other = model.steps[model.supported_step];
  if (step.supports != other.supports)
    model.mesh.notes.push_back(
        located(sources, step.place) + "this step has other supports than step " +
        std::to_string(model.supported_step) +
        ", whose supports ritz-reduce and ritz-full take from the deck: say those of this step by -fix");
}

}  // namespace

double inp_number(const Sources& sources, const std::vector<Line>& fields, std::size_t at, std::string_view what) {
  if (at >= fields.size()) return 0;
  Cursor cursor(sources, fields[at].place, fields[at].text.size());
  const double value = cursor.line_ends() ? 0 : cursor.real(what);
  cursor.end_line();
  return value;
}

InpAnalysis inp_analysis(const Sources& sources, InpModel& model, std::optional<int> number) {
  if (const auto& loads = model.steps.front().loads; !loads.empty())
    fail(sources, loads.front().fields[0].place, "a load stands outside of the steps");
  const auto s = asked_step(sources, model, number);
  const auto& step = model.steps[s];
  const auto& procedure = *step.procedure;
  refuse_procedure(sources, model, procedure.keyword);
  const auto [increment, period] = times_of(sources, procedure);
  InpAnalysis analysis{.step = s,
                       .motion = procedure.keyword.name != "STATIC",
                       .increment = increment,
                       .period = period,
                       .before = time_before(sources, model, s),
                       .ramped = false};
  analysis.ramped = is_ramped(sources, step, analysis.motion);
  if (analysis.motion) check_motion_times(sources, procedure, analysis);
  else read_static_times(analysis);
  refuse_history(sources, model, analysis);
  refuse_fixed(sources, model, analysis);
  note_way(sources, model, analysis);
  note_supports(sources, model, analysis);
  return analysis;
}

}  // namespace ritz::readers
