// Finds the name that a user probably meant.
#pragma once
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace ritz {

/// The number of insertions, deletions and substitutions of one character, and of swaps of neighbours, that turn `a`
/// into `b` (optimal string alignment). Upper and lower case are equal.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto same = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  };
  std::vector<std::size_t> before_last, last, now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) now[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = std::move(last);
    last = now;
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1);
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, substitution});
      if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
        now[j] = std::min(now[j], before_last[j - 2] + 1);
    }
  }
  return now[b.size()];
}

/// The candidate with the smallest edit distance to `word`, the first of several; empty when there is none.
/// `candidates` is any range whose elements convert to std::string_view.
template <class Range>
std::string nearest(std::string_view word, const Range& candidates) {
  std::string best;
  auto least = std::numeric_limits<std::size_t>::max();
  for (const auto& candidate : candidates) {
    const std::string_view name(candidate);
    const std::size_t distance = edit_distance(word, name);
    if (distance >= least) continue;
    least = distance;
    best = name;
  }
  return best;
}

/// What a user may have meant by `word`: the candidate that a few slips of the pen turn into it, else the shortest one
/// that contains it ("young": "material_young"); empty if there is none.
template <class Range>
std::string meant_by(std::string_view word, const Range& candidates) {
  const std::string near = nearest(word, candidates);
  if (!near.empty() && 2 * edit_distance(word, near) < std::max(word.size(), near.size())) return near;
  std::string shortest;
  for (const auto& candidate : candidates) {
    const std::string_view name(candidate);
    if (word.size() < 4 || name.find(word) == name.npos) continue;
    if (shortest.empty() || name.size() < shortest.size()) shortest = name;
  }
  return shortest;
}

/// "; did you mean 'tip'?" where something may have been meant, else nothing: for messages that list the words
/// themselves.
template <class Range>
std::string guess(std::string_view word, const Range& candidates) {
  const std::string meant = meant_by(word, candidates);
  return meant.empty() ? "" : "; did you mean '" + meant + "'?";
}

/// How a message on an unknown word ends: "; did you mean 'tip'? There are 'tip' and 'root'". Nothing is guessed where
/// nothing is alike, and of more than twelve candidates only those are listed that fit in a sentence. `written` is how
/// a name is put into the message.
template <class Range, class Written>
std::string hint(std::string_view word, const Range& candidates, const Written& written) {
  constexpr std::size_t most = 12;
  const std::string meant = meant_by(word, candidates);
  std::vector<std::string> names;
  for (const auto& candidate : candidates) names.emplace_back(candidate);
  const std::string guessed = meant.empty() ? "" : "; did you mean " + written(meant) + "?";
  if (!guessed.empty() && (names.size() < 2 || names.size() > most)) return guessed;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    list += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + written(names[i]);
  if (names.size() > most) list += " and " + std::to_string(names.size() - most) + " others";
  if (list.empty()) return "";
  return guessed.empty() ? "; there " + std::string(names.size() == 1 ? "is " : "are ") + list
                         : guessed + " There are " + list;
}

template <class Range>
std::string hint(std::string_view word, const Range& candidates) {
  return hint(word, candidates, [](const std::string& name) { return "'" + name + "'"; });
}

}  // namespace ritz
