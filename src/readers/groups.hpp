// Groups of cells that a file tells apart by dimension and number: they become regions and sets.
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

/// Puts the cell listed last into a group.
void join_group(Groups& groups, ListedMesh& mesh, Index tag);

/// Makes the sets and, of groups of solids, the regions, when the whole file is read. A group
/// without a name is named by its number. Groups of one name and dimension are one set.
void name_groups(const Groups& groups, ListedMesh& mesh);

/// A part of the body by name.
struct Volume {
  std::string name;
  std::vector<Index> cells;  ///< ascending
};

/// The regions that volumes cut the solid cells into: one for each combination of volumes that cells lie in.
void make_regions(std::vector<Volume> volumes, ListedMesh& mesh);

}  // namespace ritz::readers
