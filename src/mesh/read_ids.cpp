#include "ritz/mesh/read_ids.hpp"

#include <algorithm>

namespace ritz::mesh {

IdMap::IdMap(std::span<const Index> ids) {
  if (ids.empty()) return;
  const auto [lowest, highest] = std::minmax_element(ids.begin(), ids.end());
  first_ = *lowest;
  const auto range = static_cast<std::uint64_t>(*highest) - static_cast<std::uint64_t>(*lowest);
  if (range < 8 * ids.size() + 1024) {
    dense_.assign(range + 1, -1);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      auto& slot = dense_[static_cast<std::size_t>(ids[i] - first_)];
      if (slot >= 0 && !duplicate_) duplicate_ = static_cast<Index>(i);
      slot = static_cast<Index>(i);
    }
    return;
  }
  sorted_.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) sorted_.emplace_back(ids[i], static_cast<Index>(i));
  std::sort(sorted_.begin(), sorted_.end());
  const auto twin = std::adjacent_find(sorted_.begin(), sorted_.end(),
                                       [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twin != sorted_.end()) duplicate_ = std::next(twin)->second;
}

Index IdMap::find(Index id) const {
  if (!dense_.empty()) {
    const auto slot = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(first_);
    return slot < dense_.size() ? dense_[slot] : -1;
  }
  const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{id, Index{0}});
  return at != sorted_.end() && at->first == id ? at->second : -1;
}

std::uint64_t IdMap::looked_at(Index first, Index last, Index step) const {
  if (!dense_.empty()) {
    const Index begin = std::max(first, first_), end = std::min(last, first_ + static_cast<Index>(dense_.size()) - 1);
    return begin > end ? 1 : static_cast<std::uint64_t>((end - begin) / step + 1);
  }
  const auto before = [](const auto& entry, Index id) { return entry.first < id; };
  const auto begin = std::lower_bound(sorted_.begin(), sorted_.end(), first, before);
  const auto end = std::lower_bound(begin, sorted_.end(), last, before);
  return static_cast<std::uint64_t>(end - begin) + 1;
}

std::vector<Index> IdMap::range(Index first, Index last, Index step) const {
  std::vector<Index> positions;
  if (!dense_.empty()) {
    const Index end = std::min(last, first_ + static_cast<Index>(dense_.size()) - 1);
    const Index skipped = first_ > first ? (first_ - first) / step : 0;  // steps that end at or before first_
    for (Index id = first + skipped * step; id <= end; id += step) {
      if (const auto position = find(id); position >= 0) positions.push_back(position);
      if (step > end - id) break;
    }
    return positions;
  }
  auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{first, Index{0}});
  for (; at != sorted_.end() && at->first <= last; ++at) {
    if ((at->first - first) % step == 0) positions.push_back(at->second);
  }
  return positions;
}

}  // namespace ritz::mesh
