#include "ritz/config/options.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"

namespace ritz::config {

std::string small_letters(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

void Given::put(const Option& option) { entries_[small_letters(option.name)] = {option}; }

void Given::add(const Option& option) { entries_.try_emplace(small_letters(option.name), Entry{option}); }

std::optional<std::string> Given::read(const std::string& name) {
  const auto found = entries_.find(small_letters(name));
  if (found == entries_.end()) return std::nullopt;
  found->second.state = State::read;
  return found->second.option.value;
}

std::vector<Option> Given::unread() const {
  std::vector<Option> unread;
  for (const auto& [key, entry] : entries_)
    if (entry.state == State::unread) unread.push_back(entry.option);
  return unread;
}

namespace {

std::string shortest(double x) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr};
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

template <class T>
T parse(const std::string& name, const std::string& word, const char* kind) {
  T value{};
  const char* first = word.data() + (word.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(first, word.data() + word.size(), value);
  if (word.empty()) throw InputError("option -" + name + " needs " + kind + " after it");
  if (error != std::errc() || end != word.data() + word.size())
    throw InputError("option -" + name + " " + word + ": that is not " + kind);
  return value;
}

}  // namespace

std::optional<std::string> Database::text(const std::string& name) {
  auto value = given_.read(name);
  if (value && value->empty()) throw InputError("option -" + name + " needs a value after it");
  if (value) resolved_.emplace_back(name, *value);
  return value;
}

std::string Database::text(const std::string& name, const std::string& fallback) {
  if (const auto value = text(name)) return *value;
  resolved_.emplace_back(name, fallback);
  return fallback;
}

int Database::integer(const std::string& name, int fallback, int least, int most) {
  int value = fallback;
  if (const auto word = given_.read(name)) value = parse<int>(name, *word, "a whole number");
  if (value < least || value > most)
    throw InputError("option -" + name + " " + std::to_string(value) + " must be at least " + std::to_string(least) +
                     (most < std::numeric_limits<int>::max() ? " and at most " + std::to_string(most) : ""));
  resolved_.emplace_back(name, std::to_string(value));
  return value;
}

std::optional<double> Database::real(const std::string& name) {
  const auto word = given_.read(name);
  if (!word) return std::nullopt;
  const auto value = parse<double>(name, *word, "a number");
  if (!std::isfinite(value)) throw InputError("option -" + name + " " + *word + ": that is not a finite number");
  resolved_.emplace_back(name, *word);
  return value;
}

std::optional<std::vector<double>> Database::reals(const std::string& name) {
  const auto text = given_.read(name);
  if (!text) return std::nullopt;
  std::vector<double> values;
  for (std::size_t start = 0; start <= text->size();) {
    const auto end = std::min(text->find(',', start), text->size());
    std::string word = text->substr(start, end - start);
    std::erase(word, ' ');
    values.push_back(word.empty() ? std::nan("") : parse<double>(name, word, "a number"));
    if (!std::isfinite(values.back()))
      throw InputError("option -" + name + " " + *text + ": write finite numbers with commas between, such as 1.5e5,2");
    start = end + 1;
  }
  resolved_.emplace_back(name, *text);
  return values;
}

double Database::real(const std::string& name, double fallback, double least, double most) {
  const auto given = real(name);
  if (!given) resolved_.emplace_back(name, shortest(fallback));
  const double value = given.value_or(fallback);
  if (!(value >= least && value <= most))
    throw InputError("option -" + name + " " + shortest(value) + " must lie between " + shortest(least) + " and " +
                     shortest(most));
  return value;
}

bool Database::flag(const std::string& name) {
  const auto word = given_.read(name);
  bool value = word.has_value();
  if (word && !word->empty()) {
    if (*word == "0" || *word == "false" || *word == "no" || *word == "off") value = false;
    else if (*word != "1" && *word != "true" && *word != "yes" && *word != "on")
      throw InputError("option -" + name + " " + *word + ": that is neither true nor false");
  }
  resolved_.emplace_back(name, value ? "true" : "false");
  return value;
}

std::size_t Database::choice(const std::string& name, const std::vector<std::string>& words, std::size_t fallback) {
  const auto word = text(name, words[fallback]);
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end())
    throw InputError("option -" + name + " " + word + " is not one of " + listed(words) + guess(word, words));
  return static_cast<std::size_t>(found - words.begin());
}

}  // namespace ritz::config
