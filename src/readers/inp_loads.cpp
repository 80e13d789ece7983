// The loads that a step has in effect: its own, and those of earlier steps.
#include <algorithm>

#include "ritz/readers/inp_scene.hpp"

namespace ritz::readers {

namespace {

// Loads of the body or of its faces that Abaqus and CalculiX have and scenes have not.
constexpr std::string_view other_labels[] = {"BX",   "BY",    "BZ",   "BXNU", "BYNU", "BZNU", "CENTRIF",
                                             "CENT", "CORIO", "ROTA", "P",    "PNU",  "HP",   "NEWTON"};
constexpr std::string_view other_parameters[] = {
    "USER",        "SUBMODEL",   "TIMEDELAY",         "SECTOR", "LOADCASE",  "FOLLOWER",
    "ORIENTATION", "REGIONTYPE", "CONSTANTRESULTANT", "REAL",   "IMAGINARY", "CYCLICMODE"};

template <class List>
bool holds(const List& list, std::string_view word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

bool is_side(std::string_view label) {
  return label.size() == 2 && label[0] == 'P' && label[1] >= '1' && label[1] <= '6';
}

// What a *CLOAD does; nothing for moments, which no vertex of a solid feels.
std::optional<InpAction> action_of_force(const Sources& sources, InpModel& model, const InpLoad& load) {
  const auto place = load.fields[0].place;
  const auto component = whole_number(label_of(load));
  if (!component || *component < 1) fail(sources, place, "*CLOAD needs a degree of freedom, 1 to 3, after the node");
  if (*component <= 3) return InpAction::force;
  if (model.words.insert("CLOAD 4").second)
    model.mesh.notes.push_back(located(sources, place) +
                               "*CLOAD on a degree of freedom beyond 3 is left out, for no vertex of a solid has such");
  return std::nullopt;
}

std::optional<InpAction> action_of(const Sources& sources, InpModel& model, const InpLoad& load) {
  const auto& keyword = keyword_of(model, load);
  const auto label = label_of(load);
  if (keyword.name == "CLOAD") return action_of_force(sources, model, load);
  if (keyword.name == "DLOAD" && label == "GRAV") return InpAction::gravity;
  if (keyword.name == "DLOAD" ? is_side(label) : label == "P") return InpAction::pressure;
  if (keyword.name == "DSLOAD" && label == "TRVEC") return InpAction::traction;
  const auto what = "*" + keyword.title + " of type '" + label + "' is no load that a scene has";
  if (!holds(other_labels, label)) fail(sources, load.fields[0].place, what);
  leave_out(sources, load.fields[0].place, {label}, what, model);
  return std::nullopt;
}

// With other parameters they are other loads.
bool leaves_out(const Sources& sources, InpModel& model, const Keyword& keyword) {
  bool out = false;
  for (const auto& [name, value] : keyword.parameters) {
    if (name == "OP" || name == "AMPLITUDE") continue;
    const auto what = "*" + keyword.title + " with '" + name + "' is no load that a scene has";
    if (!holds(other_parameters, name)) fail(sources, keyword.place, what);
    leave_out(sources, keyword.place, {name}, what, model);
    out = true;
  }
  return out;
}

// Those that a scene has, without what they act on.
std::vector<InpActing> loads_of(const Sources& sources, InpModel& model, std::size_t step) {
  std::vector<InpActing> loads;
  for (const auto& load : model.steps[step].loads) {
    const auto& keyword = keyword_of(model, load);
    if (load.joined || leaves_out(sources, model, keyword)) continue;
    if (load.target.empty() && label_of(load) != "GRAV")
      fail(sources, load.fields[0].place, "*" + keyword.title + " needs a node, an element, a set or a surface here");
    if (const auto action = action_of(sources, model, load))
      loads.push_back({.load = &load, .step = step, .action = *action});
  }
  return loads;
}

enum class LoadFamily { forces, pressures };

LoadFamily family_of(const Keyword& keyword) {
  return keyword.name == "CLOAD" ? LoadFamily::forces : LoadFamily::pressures;
}

// Whether the loads of a family in a step have OP=NEW, and so remove those of earlier steps.
bool begins_anew(const Sources& sources, const InpModel& model, std::size_t step, LoadFamily family) {
  std::optional<bool> anew;
  for (const auto& load : model.steps[step].loads) {
    const auto& keyword = keyword_of(model, load);
    if (family_of(keyword) != family) continue;
    const auto op = upper(keyword.value("OP").value_or("MOD"));
    if (op != "NEW" && op != "MOD") fail(sources, keyword.place, "*" + keyword.title + " has OP=NEW and OP=MOD alone");
    if (anew && *anew != (op == "NEW"))
      fail(sources, keyword.place, "this step says OP=NEW of some loads and not of others; say it of all or of none");
    anew = op == "NEW";
  }
  return anew.value_or(false);
}

// CalculiX then removes those of the other keyword as well, and Abaqus does not.
void refuse_half_new(const Sources& sources, const InpModel& model, const std::vector<InpActing>& before,
                     std::size_t step) {
  std::set<std::string> said;
  for (const auto& load : model.steps[step].loads) said.insert(keyword_of(model, load).name);
  for (const auto& acting : before)
    if (const auto& keyword = keyword_of(model, *acting.load); keyword.name != "CLOAD" && !said.contains(keyword.name))
      fail(sources, model.steps[step].place,
           "this step says OP=NEW, but not of *" + keyword.name +
               ", of which an earlier step has some: programs differ on whether these go; say OP=NEW of *DLOAD and of "
               "*DSLOAD");
}

using OnWhat = std::pair<InpAction, Index>;

// Pressures and tractions act on the same faces.
OnWhat on_what(const InpActing& acting, Index i) {
  return {acting.action == InpAction::traction ? InpAction::pressure : acting.action, i};
}

// Whether a load of a later step takes the place of this one, in all programs.
bool replaces(const Sources& sources, const InpModel& model, const InpActing& now, const InpActing& old) {
  if (now.action != old.action || keyword_of(model, *now.load).name != keyword_of(model, *old.load).name) return false;
  if (old.action == InpAction::force || old.action == InpAction::pressure) return true;
  return inp_vector(sources, *now.load) == inp_vector(sources, *old.load);
}

// The loads of earlier steps that those of a step leave in effect: as a whole, or not at all.
std::vector<InpActing> kept(const Sources& sources, const InpModel& model, const std::vector<InpActing>& before,
                            const std::vector<InpActing>& step) {
  std::multimap<OnWhat, const InpActing*> now;
  if (!before.empty())
    for (const auto& acting : step)
      for (const Index i : acting.on) now.emplace(on_what(acting, i), &acting);
  std::vector<InpActing> left;
  for (const auto& old : before) {
    std::size_t changed = 0;
    bool clear = true;
    for (const Index i : old.on) {
      const auto [first, last] = now.equal_range(on_what(old, i));
      changed += first != last;
      clear = clear && std::all_of(first, last, [&](auto& it) { return replaces(sources, model, *it.second, old); });
    }
    if (!clear || (changed > 0 && changed < old.on.size()))
      fail(sources, old.load->fields[0].place,
           "a later step loads what this load acts on, or a part of it, in another way: what is then in effect is not "
           "the same in all programs; let that step say all its loads, with OP=NEW");
    if (changed == 0) left.push_back(old);
  }
  return left;
}

}  // namespace

const Keyword& keyword_of(const InpModel& model, const InpLoad& load) { return model.load_keywords[load.keyword]; }

std::string label_of(const InpLoad& load) { return load.fields.size() > 1 ? upper(load.fields[1].text) : ""; }

std::vector<InpActing> inp_loads(const Sources& sources, InpModel& model, const InpAnalysis& analysis) {
  std::vector<std::vector<InpActing>> steps(1);  // none of the model data
  for (std::size_t s = 1; s <= analysis.step; ++s) steps.push_back(loads_of(sources, model, s));
  find_targets(sources, model, steps);
  std::vector<InpActing> in_effect;
  for (std::size_t s = 1; s <= analysis.step; ++s) {
    for (const auto family : {LoadFamily::forces, LoadFamily::pressures}) {
      if (!begins_anew(sources, model, s, family)) continue;
      if (family == LoadFamily::pressures) refuse_half_new(sources, model, in_effect, s);
      std::erase_if(in_effect, [&](auto& old) { return family_of(keyword_of(model, *old.load)) == family; });
    }
    in_effect = kept(sources, model, in_effect, steps[s]);
    in_effect.insert(in_effect.end(), steps[s].begin(), steps[s].end());
  }
  return in_effect;
}

}  // namespace ritz::readers
