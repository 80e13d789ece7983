// Groups of cells that a file identifies by dimension and number; they become regions and sets.
#pragma once
#include <map>
#include <utility>

#include "ritz/readers/listed.hpp"

namespace ritz::readers {

/// Groups by (dimension, tag).
struct Groups {
  using Key = std::pair<int, Index>;
  std::map<Key, std::string> names;
  std::map<Key, std::vector<Index>> cells;  ///< positions in the listed mesh, ascending
};

/// Adds the cell that was listed last to a group.
void join_group(Groups& groups, ListedMesh& mesh, Index tag);

/// Makes the sets and, from groups of solid cells, the regions, after the whole file is read. A group without a name
/// gets its number as name. Groups with the same name and dimension are one set.
void name_groups(const Groups& groups, ListedMesh& mesh);

/// A named part of the body.
struct Volume {
  std::string name;
  std::vector<Index> cells;  ///< ascending
};

/// Makes the regions into which the volumes divide the solid cells: one for each combination of volumes.
void make_regions(std::vector<Volume> volumes, ListedMesh& mesh);

}  // namespace ritz::readers
