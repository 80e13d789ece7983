// From a file's own numbers to positions.
#pragma once
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ritz/mesh/file_mesh.hpp"

namespace ritz::mesh {

/// The position of each number in a list. Numbers may be sparse and in any order; memory is proportional to the list.
class IdMap {
 public:
  explicit IdMap(std::span<const Index> ids);

  /// The position of `id`, or -1.
  Index find(Index id) const;
  /// The position of a number that also stands earlier in the list.
  std::optional<Index> duplicate() const { return duplicate_; }
  /// The positions of the listed ids among first, first + step, ... <= last (0 <= first <= last, step > 0).
  std::vector<Index> range(Index first, Index last, Index step) const;
  /// How many numbers range() looks at.
  std::uint64_t looked_at(Index first, Index last, Index step) const;

 private:
  Index first_ = 0;
  std::vector<Index> dense_;                     ///< position of id first_ + i, or -1
  std::vector<std::pair<Index, Index>> sorted_;  ///< (id, position), when ids are too sparse for a table
  std::optional<Index> duplicate_;
};

}  // namespace ritz::mesh
