// *NSET, *ELSET and *SURFACE.
#include "ritz/readers/inp_model.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace ritz::readers {

namespace {

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("+-0123456789") == std::string_view::npos;
}

InpMember read_range(const Deck& deck, const Line& line, Index added) {
  auto cursor = deck.cursor(line);
  InpMember range{.first = 0, .last = 0, .step = 1, .place = line.place, .added = added};
  range.first = cursor.integer("the first number");
  range.last = cursor.integer("the last number");
  if (!cursor.line_ends()) range.step = cursor.integer("the step");
  cursor.end_line();
  if (range.first < 0 || range.last < range.first || range.step < 1) {
    deck.fail(line.place, "GENERATE needs first <= last and a positive step");
  }
  range.first = full_number(deck, line.place, range.first, added);
  range.last = full_number(deck, line.place, range.last, added);
  return range;
}

// Takes the sets named inside another one as they stand, each once.
void add_parts(InpSets& sets, std::size_t into, const std::set<std::size_t>& named) {
  for (const std::size_t other : named) {
    if (other != into) sets.sets[into].parts.push_back(whole(sets, other));
  }
}

// A line of flags after a comma at the end of a keyword line may be meant as names of sets.
void refuse_doubt(const Deck& deck, const Keyword& keyword, const InpScope& scope, const InpSets& sets) {
  for (const auto& line : keyword.flag_lines)
    for (const auto& field : fields(line))
      if (sets.find(full_name(scope, plain_name(field.text))))
        deck.fail(field.place, "'" + plain_name(field.text) + "' is a parameter of *" + keyword.title +
                                   " and the name of a set; write the parameter in the line of the keyword, or leave "
                                   "out the comma at its end");
}

/// Where the lines of a *NSET or *ELSET belong.
struct SetLines {
  InpSets& sets;
  std::size_t into;
  const InpScope& scope;
  Index added;  ///< to numbers
};

// In the assembly, the lines of a set with INSTANCE= may call the instance's sets by their own names.
const InpSet* named_set(const SetLines& lines, const std::string& name) {
  const auto* const own = lines.sets.find(full_name(lines.scope, name));
  return own ? own : lines.sets.find(name);
}

// Numbers, and names of sets that stand earlier in the file.
void read_list(const Deck& deck, const Line& line, const SetLines& lines, std::set<std::size_t>& named) {
  for (const auto& field : fields(line)) {
    if (field.text.empty()) continue;
    if (is_number(field.text)) {
      const Index written = deck.cursor(field).integer("a number");
      if (written < 0) deck.fail(field.place, "a set names the negative number " + std::to_string(written));
      const Index number = full_number(deck, field.place, written, lines.added);
      lines.sets.sets[lines.into].members.push_back(
          {.first = number, .last = number, .step = 0, .place = field.place, .added = lines.added});
      continue;
    }
    const auto* const other = named_set(lines, plain_name(field.text));
    if (!other) deck.fail(field.place, "set '" + plain_name(field.text) + "' is not defined before this line");
    named.insert(static_cast<std::size_t>(other - lines.sets.sets.data()));
  }
}

void read_set(Deck& deck, const Keyword& keyword, const SetLines& lines) {
  refuse_doubt(deck, keyword, lines.scope, lines.sets);
  const bool ranges = keyword.has("GENERATE");
  std::set<std::size_t> named;
  while (const auto line = deck.next_data()) {
    if (ranges) lines.sets.sets[lines.into].members.push_back(read_range(deck, *line, lines.added));
    else read_list(deck, *line, lines, named);
  }
  add_parts(lines.sets, lines.into, named);
}

// What needs such a surface, as contact does, is refused by its own keyword.
void note_unread(const Deck& deck, const Keyword& keyword, const std::string& kind, InpModel& model) {
  const auto note = located(deck.sources(), keyword.place) + "surface '" + needed(deck, keyword, "NAME") + "' (" +
                    kind + ") is not read, so that nothing can be named by it";
  if (model.words.insert(note).second) model.mesh.notes.push_back(note);
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
  const auto set = model.node_sets.made(full_name(model.scope, needed(deck, keyword, "NSET")));
  const auto& scope = scope_of(deck, keyword, model);
  if (const auto elements = keyword.value("ELSET")) {
    const auto name = full_name(scope, *elements);
    if (!model.element_sets.find(name))
      deck.fail(keyword.place, "element set '" + *elements + "' is not defined before this line");
    model.node_sets.sets[set].element_sets.push_back(model.element_sets.made(name));
  }
  read_set(deck, keyword, {model.node_sets, set, scope, scope.nodes});
}

void read_inp_elset(Deck& deck, const Keyword& keyword, InpModel& model) {
  const auto set = model.element_sets.made(full_name(model.scope, needed(deck, keyword, "ELSET")));
  const auto& scope = scope_of(deck, keyword, model);
  read_set(deck, keyword, {model.element_sets, set, scope, scope.elements});
}

void read_inp_surface(Deck& deck, const Keyword& keyword, InpModel& model) {
  const auto type = upper(keyword.value("TYPE").value_or("ELEMENT"));
  if (type != "ELEMENT" && type != "NODE") return note_unread(deck, keyword, "TYPE=" + type, model);
  if (const auto combined = keyword.value("COMBINE"))
    return note_unread(deck, keyword, "COMBINE=" + upper(*combined), model);
  InpSurface surface{.name = full_name(model.scope, needed(deck, keyword, "NAME")),
                     .type = type == "NODE" ? InpSurfaceType::node : InpSurfaceType::element,
                     .entries = {}};
  std::set<std::pair<std::string, std::string>> listed;
  while (const auto line = deck.next_data()) {
    const auto parts = fields(*line);
    if (parts[0].text.empty()) return note_unread(deck, keyword, "all that is outside", model);
    const auto kind = surface.type == InpSurfaceType::node ? InpKind::node : InpKind::element;
    const auto target = full_target(deck, parts[0], kind, model);
    const auto label = parts.size() > 1 ? upper(parts[1].text) : std::string();
    if (listed.emplace(upper(target), label).second)
      surface.entries.push_back({.target = target, .label = label, .place = line->place});
  }
  model.surfaces.push_back(std::move(surface));
}

namespace {

/// The lists of a set and of those inside it, before their numbers are looked up.
struct Gathered {
  InpContent content;
  std::vector<InpMember> members;
};

std::uint64_t take(Gathered& to, const InpSet& set, const InpPart& from, const InpPart& until) {
  const auto slice = [](const auto& list, std::size_t begin, std::size_t end) {
    return std::span(list).subspan(begin, end - begin);
  };
  const auto positions = slice(set.positions, from.positions, until.positions);
  const auto members = slice(set.members, from.members, until.members);
  const auto elements = slice(set.element_sets, from.element_sets, until.element_sets);
  to.content.positions.insert(to.content.positions.end(), positions.begin(), positions.end());
  to.members.insert(to.members.end(), members.begin(), members.end());
  to.content.element_sets.insert(elements.begin(), elements.end());
  return 1 + positions.size() + members.size() + elements.size();
}

// A set can stand inside another one by many ways, each time as it stood then: the lists only grow, so that what is
// new since the last time is enough.
Gathered gather(const Sources& sources, const InpSets& sets, std::size_t root, InpBudget& budget) {
  Gathered result;
  std::map<std::size_t, InpPart> done;
  for (std::vector<InpPart> open = {whole(sets, root)}; !open.empty();) {
    const auto part = open.back();
    open.pop_back();
    const auto& set = sets.sets[part.set];
    auto& from = done.try_emplace(part.set, InpPart{part.set, 0, 0, 0, 0}).first->second;
    const InpPart until{part.set, std::max(from.positions, part.positions), std::max(from.members, part.members),
                        std::max(from.parts, part.parts), std::max(from.element_sets, part.element_sets)};
    budget.spend(sources, sets.sets[root].name, take(result, set, from, until));
    for (std::size_t p = from.parts; p < until.parts; ++p) open.push_back(set.parts[p]);
    from = until;
  }
  return result;
}

void note_missing(const Sources& sources, const InpMember& member, const std::string& set, const std::string& what,
                  InpMissing& missing) {
  if (missing.all.empty())
    missing.first = located(sources, member.place) + "set '" + set + "' names " + what + " " +
                    std::to_string(member.first) + ", which the file does not list";
  missing.all.emplace(member.place.file, member.place.offset);
}

// Ranges of the same stride that meet or overlap become one.
std::vector<InpMember> joined(std::vector<InpMember> ranges) {
  const auto stride = [](const InpMember& m) { return std::pair(m.step, m.first % m.step); };
  std::sort(ranges.begin(), ranges.end(), [&](const auto& a, const auto& b) {
    return std::tuple(stride(a), a.first, a.last) < std::tuple(stride(b), b.first, b.last);
  });
  std::vector<InpMember> result;
  for (const auto& range : ranges) {
    const bool meets =
        !result.empty() && stride(result.back()) == stride(range) && range.first - range.step <= result.back().last;
    if (meets) result.back().last = std::max(result.back().last, range.last);
    else result.push_back(range);
  }
  return result;
}

}  // namespace

InpBudget::InpBudget(const Sources& sources) : allowed_(4'000'000) {
  for (const auto& source : sources) allowed_ += 2 * source.bytes.size();
}

void InpBudget::spend(const Sources& sources, const std::string& set, std::uint64_t entries) {
  spent_ += entries;
  if (spent_ > allowed_)
    fail(sources, "the sets of the file up to '" + set + "' list more than " + std::to_string(allowed_) +
                      " nodes and elements in all, out of proportion to its size; leave out sets that repeat others");
}

void keep_unique(std::vector<Index>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

InpContent content(const Sources& sources, const InpSets& sets, std::size_t set, const IdMap& ids,
                   const std::string& what, InpBudget& budget, InpMissing& missing) {
  auto [result, members] = gather(sources, sets, set, budget);
  result.by_number = !members.empty();
  const auto& name = sets.sets[set].name;
  std::vector<InpMember> ranges;
  for (const auto& member : members) {
    const Index position = member.step == 0 ? ids.find(member.first) : -1;
    if (member.step > 0) ranges.push_back(member);
    else if (position < 0) note_missing(sources, member, name, what, missing);
    else result.positions.push_back(position);
  }
  for (const auto& range : joined(std::move(ranges))) {
    budget.spend(sources, name, ids.looked_at(range.first, range.last, range.step));
    const auto found = ids.range(range.first, range.last, range.step);
    if (found.empty()) note_missing(sources, range, name, what, missing);
    result.positions.insert(result.positions.end(), found.begin(), found.end());
  }
  keep_unique(result.positions);
  return result;
}

}  // namespace ritz::readers
