// *PART, *ASSEMBLY and *INSTANCE. The lines of a part are read once for each instance: in its scope, numbers are raised
// above those of the instances before, names of sets become "INSTANCE.NAME", and nodes are placed.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "ritz/readers/inp_model.hpp"

namespace ritz::readers {

namespace {

constexpr Index largest_number = Index{1} << 53;

/// "INSTANCE.NAME" in an assembly; nothing if no instance of that name has been read.
struct Dotted {
  const InpScope& scope;
  std::string_view name;
};

std::optional<Dotted> dotted(const InpModel& model, std::string_view text) {
  for (auto dot = text.find('.'); dot != text.npos; dot = text.find('.', dot + 1)) {
    const auto found = model.instances.find(upper(text.substr(0, dot)));
    if (found != model.instances.end()) return Dotted{found->second, text.substr(dot + 1)};
  }
  return std::nullopt;
}

Index added(const InpScope& scope, InpKind kind) { return kind == InpKind::node ? scope.nodes : scope.elements; }

std::array<double, 3> difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double product(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Up to `count` numbers; a field that is blank or absent is 0.
template <std::size_t count>
std::array<double, count> numbers_of(const Deck& deck, const Line& line, std::string_view what) {
  std::array<double, count> values{};
  const auto parts = fields(line);
  if (parts.size() > count) deck.fail(parts[count].place, "expected " + std::to_string(count) + " numbers here");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    auto cursor = deck.cursor(parts[i]);
    if (!cursor.line_ends()) values[i] = cursor.real(what);
    cursor.end_line();
  }
  return values;
}

// Two points of an axis, and an angle in degrees.
void read_rotation(const Deck& deck, const Line& line, InpScope& scope) {
  const auto [ax, ay, az, bx, by, bz, degrees] = numbers_of<7>(deck, line, "a point of the axis, or an angle");
  scope.origin = {ax, ay, az};
  scope.axis = difference({bx, by, bz}, scope.origin);
  const double length = std::hypot(scope.axis[0], scope.axis[1], scope.axis[2]);
  if (!(length > 0)) deck.fail(line.place, "the two points of the axis of rotation are the same");
  for (double& component : scope.axis) component /= length;
  // Quarters of a turn are exact.
  const double quarters = std::round(degrees / 90), rest = (degrees - 90 * quarters) * std::numbers::pi / 180;
  const double c = std::cos(rest), s = std::sin(rest);
  switch (static_cast<int>(std::fmod(quarters, 4) + 4) % 4) {
    case 0: scope.cosine = c, scope.sine = s; break;
    case 1: scope.cosine = -s, scope.sine = c; break;
    case 2: scope.cosine = -c, scope.sine = -s; break;
    default: scope.cosine = s, scope.sine = -c; break;
  }
}

void read_placement(Deck& deck, InpScope& scope) {
  if (const auto line = deck.next_data()) scope.translation = numbers_of<3>(deck, *line, "a translation");
  if (const auto line = deck.next_data()) read_rotation(deck, *line, scope);
  if (const auto line = deck.next_data())
    deck.fail(line->place, "*INSTANCE has two data lines, a translation and a rotation");
}

// A short file can ask for the same part very often.
void count_again(const Deck& deck, const Keyword& keyword, std::size_t characters, InpModel& model) {
  std::size_t bytes = 0;
  for (const auto& source : deck.sources()) bytes += source.bytes.size();
  model.characters_again += characters;
  if (model.characters_again > 64 * bytes + (std::size_t{1} << 25))
    deck.fail(keyword.place,
              "the instances up to this one repeat their parts out of proportion to the size of the file");
}

}  // namespace

std::string full_name(const InpScope& scope, const std::string& name) {
  return scope.name.empty() ? name : scope.name + "." + name;
}

Index full_number(const Deck& deck, Place place, Index number, Index added) {
  if (added == 0) return number;
  if (number > largest_number || number < -largest_number || added > largest_number)
    deck.fail(place, "the number " + std::to_string(number) + " is too large for a part");
  return number + added;
}

const InpScope& scope_of(const Deck& deck, const Keyword& keyword, const InpModel& model) {
  const auto name = keyword.value("INSTANCE");
  if (!name) return model.scope;
  const auto found = model.instances.find(upper(*name));
  if (found == model.instances.end())
    deck.fail(keyword.place, "instance '" + *name + "' is not defined before this line");
  return found->second;
}

std::optional<Index> whole_number(std::string_view text) {
  Index number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

std::string full_target(const Deck& deck, const Line& field, InpKind kind, const InpModel& model) {
  const auto name = plain_name(field.text);
  const auto said = dotted(model, name);
  const auto& scope = said ? said->scope : model.scope;
  const std::string_view own = said ? said->name : std::string_view(name);
  if (const auto number = whole_number(own))
    return std::to_string(full_number(deck, field.place, *number, added(scope, kind)));
  return said ? name : full_name(scope, name);
}

std::array<double, 3> placed(const InpScope& scope, const std::array<double, 3>& point) {
  if (scope.name.empty()) return point;
  std::array<double, 3> moved = point;
  for (std::size_t i = 0; i < 3; ++i) moved[i] += scope.translation[i];
  if (scope.cosine == 1) return moved;
  const auto arm = difference(moved, scope.origin);
  const auto& k = scope.axis;
  const double along = product(k, arm) * (1 - scope.cosine);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
    moved[i] = scope.origin[i] + arm[i] * scope.cosine + (k[j] * arm[l] - k[l] * arm[j]) * scope.sine + k[i] * along;
  }
  return moved;
}

void read_inp_part(Deck& deck, const Keyword& keyword, InpModel& model) {
  const auto name = needed(deck, keyword, "NAME");
  if (!model.scope.name.empty()) deck.fail(keyword.place, "*PART stands inside an instance");
  if (!model.part_lines.try_emplace(upper(name), InpPartLines{deck, keyword.place}).second)
    deck.fail(keyword.place, "part '" + name + "' is defined twice");
  while (const auto inner = deck.next_keyword()) {
    if (inner->name == "ENDPART") return;
    if (inner->name == "PART") deck.fail(inner->place, "*PART stands inside a part; *END PART is missing before it");
  }
  deck.fail(keyword.place, "the file ends before the *END PART of this part");
}

void read_inp_assembly(Deck& deck, const Keyword& keyword, InpModel& model) {
  if (!model.scope.name.empty()) deck.fail(keyword.place, "*ASSEMBLY stands inside an instance");
  read_keywords(deck, "ENDASSEMBLY", keyword.place, model);
}

void read_inp_instance(Deck& deck, const Keyword& keyword, InpModel& model) {
  const auto name = needed(deck, keyword, "NAME");
  if (!model.scope.name.empty()) deck.fail(keyword.place, "*INSTANCE stands inside an instance");
  if (keyword.has("LIBRARY") || keyword.has("INSTANCE"))
    deck.fail(keyword.place, "instances of another analysis (LIBRARY=, INSTANCE=) are not supported");
  const auto part_name = needed(deck, keyword, "PART");
  const auto part = model.part_lines.find(upper(part_name));
  if (part == model.part_lines.end())
    deck.fail(keyword.place, "part '" + part_name + "' is not defined before this line");
  if (model.instances.contains(upper(name))) deck.fail(keyword.place, "instance '" + name + "' is defined twice");

  if (model.last_node != model.scope.nodes || model.last_element != model.scope.elements)
    deck.fail(keyword.place,
              "nodes or elements outside of instances stand before this instance, which is not supported");

  model.scope = {.name = name, .nodes = model.last_node, .elements = model.last_element};
  read_placement(deck, model.scope);
  Deck again = part->second.lines;
  const auto before = again.characters_read();
  read_keywords(again, "ENDPART", part->second.place, model);
  read_keywords(deck, "ENDINSTANCE", keyword.place, model);
  model.instances.emplace(upper(name), model.scope);
  // Nodes of the assembly itself, such as reference points, have numbers of their own.
  model.scope = {.nodes = model.last_node, .elements = model.last_element};
  count_again(deck, keyword, again.characters_read() - before, model);
}

void note_instances(InpModel& model) {
  if (model.instances.size() < 2) return;
  std::vector<const InpScope*> scopes;
  for (const auto& [name, scope] : model.instances) scopes.push_back(&scope);
  std::sort(scopes.begin(), scopes.end(), [](const auto* a, const auto* b) { return a->nodes < b->nodes; });
  constexpr std::size_t shown = 6;
  std::string list;
  for (std::size_t i = 0; i < std::min(shown, scopes.size()); ++i)
    list += (i > 0 ? ", " : "") + scopes[i]->name + " + " + std::to_string(scopes[i]->nodes);
  if (scopes.size() > shown) list += ", ...";
  model.mesh.notes.push_back("the file has " + std::to_string(scopes.size()) +
                             " instances, whose nodes have the numbers of their part plus: " + list);
}

}  // namespace ritz::readers
