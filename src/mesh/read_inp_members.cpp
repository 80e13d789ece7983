#include "ritz/mesh/read_inp_members.hpp"

#include <algorithm>
#include <tuple>

namespace ritz::mesh {
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

}  // namespace ritz::mesh
