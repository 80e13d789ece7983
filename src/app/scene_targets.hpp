// The named sets and single vertices of a scene, in the distributed mesh.
#pragma once
#include "ritz/mesh/mesh.hpp"
#include "ritz/scene/scene.hpp"

namespace ritz::app {

/// The set that a force or a probe means by this name (base/set_name.hpp). Throws InputError for a set that the mesh
/// does not have (naming the nearest one), that is ambiguous, or that is empty.
const mesh::Set& find_set(const mesh::Mesh& mesh, const std::string& name);

/// The set that a pressure or a traction means by this name. Throws InputError as above, and for a set without boundary
/// faces; `what` is the kind of load in the message.
const mesh::Set& find_surface(const mesh::Mesh& mesh, const std::string& name, const std::string& what);

/// *Collective*. Throws InputError on all ranks when no rank owns a vertex with number `id` in the mesh file.
void require_vertex(const mesh::Mesh& mesh, std::int64_t id);

}  // namespace ritz::app
