// From the sets of an .inp file to positions of nodes and elements.
#pragma once
#include <set>

#include "ritz/mesh/read_inp_model.hpp"

namespace ritz::mesh {

/// A file of few lines can list the same numbers without end (ranges, sets of sets). What all its sets list in all is
/// bounded by the file's size, generously.
class InpBudget {
 public:
  explicit InpBudget(const Sources& sources);
  /// Throws InputError, which names the set, when all sets so far list more than the file's size warrants.
  void spend(const Sources& sources, const std::string& set, std::uint64_t entries);

 private:
  std::uint64_t allowed_;
  std::uint64_t spent_ = 0;
};

/// Numbers that sets list and that the file does not have.
struct InpMissing {
  std::string first;                                      ///< a sentence on the first one
  std::set<std::pair<std::uint64_t, std::uint64_t>> all;  ///< file and offset of each
};

/// The positions, ascending, of what a set lists, and the element sets whose nodes it takes.
struct InpContent {
  std::vector<Index> positions;
  std::set<std::size_t> element_sets;
  bool by_number = false;  ///< some are listed by *NSET or *ELSET, not all by the keywords that define them
};

/// `what` is "node" or "element". Throws InputError.
InpContent content(const Sources& sources, const InpSets& sets, std::size_t set, const IdMap& ids,
                   const std::string& what, InpBudget& budget, InpMissing& missing);

/// Each value once, ascending.
void keep_unique(std::vector<Index>& values);

}  // namespace ritz::mesh
