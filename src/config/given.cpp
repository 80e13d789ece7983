#include "ritz/config/given.hpp"

#include <cctype>

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

}  // namespace ritz::config
