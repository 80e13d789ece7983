#include "ritz/app/scene_targets.hpp"

#include <algorithm>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/set_name.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::app {

namespace {

const mesh::Set& meant_set(const mesh::Mesh& mesh, const std::string& name, SetUse use) {
  std::vector<std::string> known;
  for (const auto& set : mesh.sets) known.push_back(set.name);
  const auto& set = *mesh.find(resolve_set(known, name, use, "the mesh, on which the scene acts,"));
  if (set.vertices_total == 0) throw InputError("the scene names the set '" + set.name + "', which is empty");
  return set;
}

}  // namespace

const mesh::Set& find_set(const mesh::Mesh& mesh, const std::string& name) {
  return meant_set(mesh, name, SetUse::vertices);
}

const mesh::Set& find_surface(const mesh::Mesh& mesh, const std::string& name, const std::string& what) {
  const mesh::Set& found = meant_set(mesh, name, SetUse::surface);
  if (found.faces_total > 0) return found;
  std::vector<std::string> surfaces;
  for (const auto& set : mesh.sets)
    if (set.faces_total > 0) surfaces.push_back(set.name);
  throw InputError(what + " needs a surface, and the set '" + found.name + "' has none" +
                   (surfaces.empty() ? "; no set of the mesh has one"
                                     : "; the nearest set with one is '" + nearest(name, surfaces) + "'"));
}

void require_vertex(const mesh::Mesh& mesh, std::int64_t id) {
  const auto end = mesh.ids.begin() + mesh.owned;
  const std::int32_t here = std::find(mesh.ids.begin(), end, id) != end;
  if (parallel::max(mesh.comm, here) > 0) return;
  const auto least = std::min_element(mesh.ids.begin(), end), most = std::max_element(mesh.ids.begin(), end);
  const std::int64_t lowest = parallel::min(mesh.comm, least == end ? std::int64_t{1} << 62 : *least);
  const std::int64_t highest = parallel::max(mesh.comm, most == end ? std::int64_t{-1} : *most);
  throw InputError("the scene names vertex " + std::to_string(id) +
                   ", which the mesh does not have, by the mesh file's own numbers; they run from " +
                   std::to_string(lowest) + " to " + std::to_string(highest));
}

}  // namespace ritz::app
