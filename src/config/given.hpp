// The options of a run in words, wherever they were written; typed reading is Database's.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ritz::config {

/// A name of an option as it is compared.
std::string small_letters(std::string name);

/// An option without its dash; an empty value: it stands alone.
struct Option {
  std::string name, value;
};

/// Each option once, and which of them were read. Names do not mind capitals.
class Given {
 public:
  void put(const Option& option);  ///< in place of an earlier value
  void add(const Option& option);  ///< unless there is a value already

  /// The value of an option, which counts as read from here on.
  std::optional<std::string> read(const std::string& name);

  /// What nobody has read so far, by name.
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
