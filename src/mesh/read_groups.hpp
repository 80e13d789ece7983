// Groups of cells that a file tells apart by dimension and number: they become regions and sets.
#pragma once
#include <map>
#include <utility>

#include "ritz/mesh/read_listed.hpp"

namespace ritz::mesh {

/// Groups by (dimension, tag).
struct Groups {
  using Key = std::pair<int, Index>;
  std::map<Key, std::string> names;
  std::map<Key, std::vector<Index>> cells;  ///< positions in the listed mesh
  std::map<Index, std::int32_t> regions;    ///< tag of solids -> position in ListedMesh::regions
};

/// Puts the cell listed last into a group. A solid's first group is its region.
void join_group(Groups& groups, ListedMesh& mesh, Index tag);

/// Names the regions and makes the sets, when the whole file is read. A group without a name is named by its number.
/// Groups of one name are one set, but solids give way to cells of lower dimension.
void name_groups(const Groups& groups, ListedMesh& mesh);

}  // namespace ritz::mesh
