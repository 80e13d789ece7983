// The same cells with quadratic shape functions: p-refinement of a mesh of linear cells.
#pragma once
#include "ritz/mesh/dofs.hpp"

namespace ritz::mesh {

/// Quadratic cells on a mesh of linear ones: Tet10 for Tet4, Hex20 for Hex8, Wedge15 for Wedge6. Their mid-edge
/// vertices are the midpoints of straight edges, so the body keeps its shape, and the displacements of the linear cells
/// are among those of the quadratic ones.
struct PRefinement {
  Mesh mesh;  ///< without sets; a rank owns the vertices that it owned, and middles of edges there; file positions
              ///< ascend, with gaps
  Dofs dofs;  ///< with the supports of the linear mesh; see p_refine
  std::vector<std::array<int, 2>> ends;  ///< of each owned vertex: the local vertices of the linear mesh whose middle
                                         ///< it is; of a corner twice the same
};

/// Whether there are quadratic cells with the corners of this linear type. Pyramids have none.
bool can_be_p_refined(fem::CellType type);

/// *Collective*. Refines a mesh all of whose cells can be. A component of a mid-edge vertex is
/// fixed where it is fixed at both ends of the edge, and either at all corners of a face that has the edge, or at no
/// other corners of any face at the ends: an edge between two supports that are apart stays free, and a support along a
/// line holds all of the line. Throws InputError when there are more degrees of freedom than PETSc can count.
PRefinement p_refine(const Mesh& mesh, const Dofs& dofs);

/// *Collective*. Displacements of the linear cells, as displacements of the quadratic ones with these `ends`.
VertexRows interpolate(const Mesh& linear, const std::vector<std::array<int, 2>>& ends, VertexRef u);

}  // namespace ritz::mesh
