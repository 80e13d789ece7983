// Typed reading of options. Each error names the option.
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ritz/config/given.hpp"

namespace ritz::config {

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
  bool flag(const std::string& name);
  /// The position of the option's value in `words`. Throws an InputError that names the nearest word.
  std::size_t choice(const std::string& name, const std::vector<std::string>& words, std::size_t fallback);

  const std::vector<std::pair<std::string, std::string>>& resolved() const { return resolved_; }

 private:
  Given& given_;
  std::vector<std::pair<std::string, std::string>> resolved_;
};

}  // namespace ritz::config
