#include "ritz/mesh/read_groups.hpp"

namespace ritz::mesh {

void join_group(Groups& groups, ListedMesh& mesh, Index tag) {
  const int dimension = traits(mesh.shapes.back()).dimension;
  auto& cells = groups.cells[{dimension, tag}];
  const auto cell = static_cast<Index>(mesh.shapes.size()) - 1;
  if (cells.empty() || cells.back() != cell) cells.push_back(cell);
  if (dimension != 3 || mesh.cell_regions.back() >= 0) return;
  const auto [region, added] = groups.regions.try_emplace(tag, static_cast<std::int32_t>(mesh.regions.size()));
  if (added) mesh.regions.emplace_back();
  mesh.cell_regions.back() = region->second;
}

void name_groups(const Groups& groups, ListedMesh& mesh) {
  const auto name_of = [&](const Groups::Key& key) {
    const auto name = groups.names.find(key);
    return name != groups.names.end() ? name->second : std::to_string(key.second);
  };
  for (const auto& [tag, region] : groups.regions)
    mesh.regions[static_cast<std::size_t>(region)].name = name_of({3, tag});

  std::map<std::string, std::size_t> positions;
  for (const auto& [key, cells] : groups.cells) {  // ascending in dimension
    const auto [position, added] = positions.try_emplace(name_of(key), mesh.sets.size());
    if (added) mesh.sets.push_back({.name = position->first, .vertices = {}, .cells = {}, .faces = {}});
    auto& set = mesh.sets[position->second];
    const auto of_solid = [&](Index cell) {
      return traits(mesh.shapes[static_cast<std::size_t>(cell)]).dimension == 3;
    };
    const bool lower = !set.cells.empty() && !of_solid(set.cells.front());
    if (key.first < 3 || !lower) set.cells.insert(set.cells.end(), cells.begin(), cells.end());
  }
}

}  // namespace ritz::mesh
