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

/// Whether `word` is `name` but for slips of the pen, which are few, and leave the first letter or swap it with the
/// next.
inline bool is_misspelt(std::string_view word, std::string_view name) {
  if (word.empty() || name.empty() || 3 * edit_distance(word, name) > std::min(word.size(), name.size())) return false;
  const auto same = [](char x, char y) { return edit_distance({&x, 1}, {&y, 1}) == 0; };
  return same(word[0], name[0]) || (word.size() > 1 && same(word[1], name[0]));
}

/// Whether one begins with the other, or ends with it, in a part long enough to mean something.
inline bool is_part(std::string_view word, std::string_view name) {
  return (word.size() > 3 && (name.starts_with(word) || name.ends_with(word))) ||
         (name.size() > 2 && word.starts_with(name)) || (name.size() > 3 && word.ends_with(name));
}

/// What a user may have meant by `word`: the candidate that a few slips of the pen turn into it, else those that begin
/// or end with it ("young": "material_young"), or it with them; nothing where none is alike, or more than four are.
template <class Range>
std::vector<std::string> meant_by(std::string_view word, const Range& candidates) {
  constexpr std::size_t most = 4;
  if (const std::string near = nearest(word, candidates); is_misspelt(word, near)) return {near};
  std::vector<std::string> parts;
  for (const auto& candidate : candidates)
    if (is_part(word, std::string_view(candidate)) &&
        std::find(parts.begin(), parts.end(), std::string(candidate)) == parts.end())
      parts.emplace_back(candidate);
  return parts.size() > most ? std::vector<std::string>() : parts;
}

/// "; did you mean 'tip' or 'top'?" where something may have been meant, else nothing. `written` is how a name is put
/// into the message.
template <class Range, class Written>
std::string guess(std::string_view word, const Range& candidates, const Written& written) {
  const auto meant = meant_by(word, candidates);
  std::string list;
  for (std::size_t i = 0; i < meant.size(); ++i)
    list += (i == 0 ? "" : i + 1 < meant.size() ? ", " : " or ") + written(meant[i]);
  return list.empty() ? "" : "; did you mean " + list + "?";
}

template <class Range>
std::string guess(std::string_view word, const Range& candidates) {
  return guess(word, candidates, [](const std::string& name) { return "'" + name + "'"; });
}

/// How a message on an unknown word ends: "; did you mean 'tip'? There are 'tip' and 'root'". Nothing is guessed where
/// nothing is alike, and of more than twelve candidates only those are listed that fit in a sentence.
template <class Range, class Written>
std::string hint(std::string_view word, const Range& candidates, const Written& written) {
  constexpr std::size_t most = 12;
  std::vector<std::string> names;
  for (const auto& candidate : candidates) names.emplace_back(candidate);
  const std::string guessed = guess(word, candidates, written);
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
