// *NSET, *ELSET and *SURFACE.
#include <algorithm>
#include <set>

#include "ritz/mesh/read_inp_model.hpp"

namespace ritz::mesh {
namespace {

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("+-0123456789") == std::string_view::npos;
}

InpMember read_range(const Deck& deck, const Line& line) {
  auto cursor = deck.cursor(line);
  InpMember range{.first = 0, .last = 0, .step = 1, .place = line.place};
  range.first = cursor.integer("the first number");
  range.last = cursor.integer("the last number");
  if (!cursor.line_ends()) range.step = cursor.integer("the step");
  cursor.end_line();
  if (range.first < 0 || range.last < range.first || range.step < 1) {
    deck.fail(line.place, "GENERATE needs first <= last and a positive step");
  }
  return range;
}

// Takes the sets named inside another one as they stand, each once.
void add_parts(InpSets& sets, std::size_t into, const std::set<std::size_t>& named) {
  for (const std::size_t other : named) {
    if (other != into) sets.sets[into].parts.push_back(whole(sets, other));
  }
}

// A line of flags after a comma at the end of a keyword line may be meant as names of sets.
void refuse_doubt(const Deck& deck, const Keyword& keyword, const InpSets& sets) {
  for (const auto& line : keyword.flag_lines)
    for (const auto& field : fields(line))
      if (sets.find(plain_name(field.text)))
        deck.fail(field.place, "'" + plain_name(field.text) + "' is a parameter of *" + keyword.title +
                                   " and the name of a set; write the parameter in the line of the keyword, or leave "
                                   "out the comma at its end");
}

// Numbers, and names of sets that stand earlier in the file.
void read_list(const Deck& deck, const Line& line, InpSet& set, const InpSets& sets, std::set<std::size_t>& named) {
  for (const auto& field : fields(line)) {
    if (field.text.empty()) continue;
    if (is_number(field.text)) {
      const Index number = deck.cursor(field).integer("a number");
      if (number < 0) deck.fail(field.place, "a set names the negative number " + std::to_string(number));
      set.members.push_back({.first = number, .last = number, .step = 0, .place = field.place});
      continue;
    }
    const auto* const other = sets.find(plain_name(field.text));
    if (!other) deck.fail(field.place, "set '" + plain_name(field.text) + "' is not defined before this line");
    named.insert(static_cast<std::size_t>(other - sets.sets.data()));
  }
}

void read_set(Deck& deck, const Keyword& keyword, InpSets& sets, std::size_t into) {
  if (keyword.has("INSTANCE")) deck.fail(keyword.place, "sets of an instance are not supported; flatten the model");
  refuse_doubt(deck, keyword, sets);
  const bool ranges = keyword.has("GENERATE");
  std::set<std::size_t> named;
  while (const auto line = deck.next_data()) {
    auto& set = sets.sets[into];
    if (ranges) set.members.push_back(read_range(deck, *line));
    else read_list(deck, *line, set, sets, named);
  }
  add_parts(sets, into, named);
}

// What needs such a surface, as contact does, is refused by its own keyword.
void note_unread(const Deck& deck, const Keyword& keyword, const std::string& kind, InpModel& model) {
  model.mesh.notes.push_back(located(deck.sources(), keyword.place) + "surface '" + needed(deck, keyword, "NAME") +
                             "' (" + kind + ") is not read, so that nothing can be named by it");
}

}  // namespace

const InpSet* InpSets::find(const std::string& name) const {
  const auto found = index.find(upper(name));
  return found != index.end() ? &sets[found->second] : nullptr;
}

std::size_t InpSets::made(const std::string& name) {
  const auto [found, added] = index.try_emplace(upper(name), sets.size());
  if (added) sets.push_back({.name = name, .positions = {}, .members = {}, .parts = {}, .element_sets = {}});
  return found->second;
}

InpPart whole(const InpSets& sets, std::size_t set) {
  const auto& s = sets.sets[set];
  return {.set = set,
          .positions = s.positions.size(),
          .members = s.members.size(),
          .parts = s.parts.size(),
          .element_sets = s.element_sets.size()};
}

void read_inp_nset(Deck& deck, const Keyword& keyword, InpModel& model) {
  const auto set = model.node_sets.made(needed(deck, keyword, "NSET"));
  if (const auto elements = keyword.value("ELSET")) {
    if (!model.element_sets.find(*elements)) {
      deck.fail(keyword.place, "element set '" + *elements + "' is not defined before this line");
    }
    model.node_sets.sets[set].element_sets.push_back(model.element_sets.made(*elements));
  }
  read_set(deck, keyword, model.node_sets, set);
}

void read_inp_elset(Deck& deck, const Keyword& keyword, InpModel& model) {
  read_set(deck, keyword, model.element_sets, model.element_sets.made(needed(deck, keyword, "ELSET")));
}

void read_inp_surface(Deck& deck, const Keyword& keyword, InpModel& model) {
  const auto type = upper(keyword.value("TYPE").value_or("ELEMENT"));
  if (type != "ELEMENT" && type != "NODE") return note_unread(deck, keyword, "TYPE=" + type, model);
  if (const auto combined = keyword.value("COMBINE"))
    return note_unread(deck, keyword, "COMBINE=" + upper(*combined), model);
  InpSurface surface{.name = needed(deck, keyword, "NAME"),
                     .type = type == "NODE" ? InpSurfaceType::node : InpSurfaceType::element,
                     .entries = {}};
  std::set<std::pair<std::string, std::string>> listed;
  while (const auto line = deck.next_data()) {
    const auto parts = fields(*line);
    if (parts[0].text.empty()) return note_unread(deck, keyword, "all that is outside", model);
    const auto target = plain_name(parts[0].text);
    const auto label = parts.size() > 1 ? upper(parts[1].text) : std::string();
    if (listed.emplace(upper(target), label).second)
      surface.entries.push_back({.target = target, .label = label, .place = line->place});
  }
  model.surfaces.push_back(std::move(surface));
}

}  // namespace ritz::mesh
