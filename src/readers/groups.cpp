#include "ritz/readers/groups.hpp"

#include <algorithm>
#include <array>

namespace ritz::readers {

void join_group(Groups& groups, ListedMesh& mesh, Index tag) {
  const int dimension = mesh.shapes.back().dimension;
  auto& cells = groups.cells[{dimension, tag}];
  const auto cell = static_cast<Index>(mesh.shapes.size()) - 1;
  if (cells.empty() || cells.back() != cell) cells.push_back(cell);
}

void name_groups(const Groups& groups, ListedMesh& mesh) {
  const auto name_of = [&](const Groups::Key& key) {
    const auto name = groups.names.find(key);
    return name != groups.names.end() ? name->second : std::to_string(key.second);
  };
  constexpr std::array<std::string_view, 4> kinds = {"point", "curve", "surface", "volume"};  // by dimension
  std::map<std::pair<int, std::string>, std::size_t> positions;
  for (const auto& [key, cells] : groups.cells) {
    const std::pair named{key.first, name_of(key)};
    const auto [position, added] = positions.try_emplace(named, mesh.sets.size());
    const auto kind = kinds[static_cast<std::size_t>(key.first)];
    if (added) mesh.sets.push_back({.name = named.second, .vertices = {}, .cells = {}, .faces = {}, .kind = kind});
    auto& set = mesh.sets[position->second];
    set.cells.insert(set.cells.end(), cells.begin(), cells.end());
  }
  std::vector<Volume> volumes;
  for (auto& set : mesh.sets) {
    std::sort(set.cells.begin(), set.cells.end());
    set.cells.erase(std::unique(set.cells.begin(), set.cells.end()), set.cells.end());
    if (set.kind == "volume") volumes.push_back({.name = set.name, .cells = set.cells});
  }
  make_regions(std::move(volumes), mesh);
}

namespace {

constexpr std::int32_t no_volume = -1;

/// Volumes that cells have in common: those of another combination and one more.
struct Combination {
  std::int32_t others;  ///< no_volume: none
  std::int32_t volume;
};

/// The combination of each cell, and what each is made of.
struct Combinations {
  std::vector<std::int32_t> of_cell;
  std::vector<Combination> list;
};

Combinations combine(const std::vector<Volume>& volumes, std::size_t cells) {
  Combinations found{.of_cell = std::vector<std::int32_t>(cells, no_volume), .list = {}};
  for (std::size_t v = 0; v < volumes.size(); ++v) {
    std::map<std::int32_t, std::int32_t> with_this;
    for (const Index cell : volumes[v].cells) {
      auto& combination = found.of_cell[static_cast<std::size_t>(cell)];
      const auto [next, added] = with_this.try_emplace(combination, static_cast<std::int32_t>(found.list.size()));
      if (added) found.list.push_back({.others = combination, .volume = static_cast<std::int32_t>(v)});
      combination = next->second;
    }
  }
  return found;
}

bool lies_in(const Volume& small, const Volume& large) {
  return small.cells.size() < large.cells.size() &&
         std::includes(large.cells.begin(), large.cells.end(), small.cells.begin(), small.cells.end());
}

/// The region of a combination; its volumes come in ascending order of their sizes.
Region region_of(const std::vector<Volume>& volumes, const std::vector<Combination>& list, std::int32_t combination) {
  std::vector<const Volume*> members;
  for (auto c = combination; c != no_volume; c = list[static_cast<std::size_t>(c)].others)
    members.push_back(&volumes[static_cast<std::size_t>(list[static_cast<std::size_t>(c)].volume)]);
  std::reverse(members.begin(), members.end());
  const auto apart = [](const Volume* small, const Volume* large) { return !lies_in(*small, *large); };
  const bool crossing = std::adjacent_find(members.begin(), members.end(), apart) != members.end();
  Region region{.name = members[0]->name};
  region.overlap = crossing ? Overlap::crossing : Overlap::nested;
  const bool same = members[0]->cells == members.back()->cells;  // of all of them, as they ascend
  if (crossing) region.parts.push_back(members[0]->name);
  for (std::size_t i = 1; i < members.size(); ++i) {
    region.parts.push_back(members[i]->name);
    if (crossing && !same) region.name += " & " + members[i]->name;
  }
  return region;
}

}  // namespace

void make_regions(std::vector<Volume> volumes, ListedMesh& mesh) {
  std::stable_sort(volumes.begin(), volumes.end(),
                   [](const Volume& a, const Volume& b) { return a.cells.size() < b.cells.size(); });
  const auto found = combine(volumes, mesh.shapes.size());
  std::vector<std::int32_t> region(found.list.size(), -1);  // in the order in which cells come upon them
  for (std::size_t cell = 0; cell < mesh.shapes.size(); ++cell) {
    const auto combination = found.of_cell[cell];
    if (combination == no_volume) continue;
    auto& number = region[static_cast<std::size_t>(combination)];
    if (number < 0) {
      number = static_cast<std::int32_t>(mesh.regions.size());
      mesh.regions.push_back(region_of(volumes, found.list, combination));
    }
    mesh.cell_regions[cell] = number;
  }
}

}  // namespace ritz::readers
