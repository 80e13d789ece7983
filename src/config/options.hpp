// The options of a run: as texts, wherever they were given, and read as typed values. Each error names the option.
#pragma once
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
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

/// Reads options, and records the value of each, default or not.
class Database {
 public:
  explicit Database(Given& given) : given_(given) {}

  bool has(const std::string& name) { return given_.read(name).has_value(); }
  std::optional<std::string> text(const std::string& name);
  std::string text(const std::string& name, const std::string& fallback);
  int integer(const std::string& name, int fallback, int least, int most = std::numeric_limits<int>::max());
  double real(const std::string& name, double fallback, double least, double most);
  std::optional<double> real(const std::string& name);
  /// Finite numbers with commas between; nothing if the option is not given.
  std::optional<std::vector<double>> reals(const std::string& name);
  bool flag(const std::string& name);
  /// The position of the option's value in `words`. Throws an InputError that names the nearest word.
  std::size_t choice(const std::string& name, const std::vector<std::string>& words, std::size_t fallback);

  const std::vector<std::pair<std::string, std::string>>& resolved() const { return resolved_; }

 private:
  Given& given_;
  std::vector<std::pair<std::string, std::string>> resolved_;
};

}  // namespace ritz::config
