// Named sets and single vertices of a scene, on the distributed mesh.
#pragma once
#include "ritz/mesh/mesh.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::app {

/// What a force or a probe means by this name (base/set_name.hpp). Throws InputError for a set that the mesh does not
/// have (naming the nearest), that is one of several, or that is empty.
const mesh::Set& find_set(const mesh::Mesh& mesh, const std::string& name);

/// What a pressure or a traction means by it. Throws as above, and for a set that bounds nothing; `what` needs the
/// surface.
const mesh::Set& find_surface(const mesh::Mesh& mesh, const std::string& name, const std::string& what);

/// Throws InputError on all ranks when no rank owns a vertex with the mesh file's own number `id`. *Collective*.
void require_vertex(const mesh::Mesh& mesh, std::int64_t id);

}  // namespace ritz::app
