#include "ritz/mesh/read_groups.hpp"

#include <algorithm>
#include <array>

namespace ritz::mesh {

void join_group(Groups& groups, ListedMesh& mesh, Index tag) {
  const int dimension = traits(mesh.shapes.back()).dimension;
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

}  // namespace ritz::mesh
