// The options of a run as texts, wherever they were given. Database reads them as typed values.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ritz::config {

/// The name of an option in small letters, in which names are compared.
std::string small_letters(std::string name);

/// An option, its name without the dash; an empty value means an option without a value.
struct Option {
  std::string name, value;
};

/// Holds each option once, and which of them were read. Names are not case-sensitive.
class Given {
 public:
  void put(const Option& option);  ///< replaces an earlier value
  void add(const Option& option);  ///< keeps an earlier value

  /// The value of an option; from now on the option counts as read.
  std::optional<std::string> read(const std::string& name);

  /// The options that have not been read, by name.
  std::vector<Option> unread() const;

 private:
  enum class State { unread, read };
  struct Entry {
    Option option;
    State state = State::unread;
  };
  std::map<std::string, Entry> entries_;  ///< by the name in small letters
};

}  // namespace ritz::config
