#include <fstream>
#include <stdexcept>

#include "fuzz/mutate.hpp"

namespace ritz::fuzz {
namespace {

/// The word between the first and the last quote of a line.
std::string unquoted(const std::string& line, const std::string& place) {
  const auto open = line.find('"'), close = line.rfind('"');
  if (open == close) throw std::runtime_error(place + ": no word in quotes");
  std::string word;
  for (auto i = open + 1; i < close; ++i) {
    if (line[i] != '\\') {
      word += line[i];
    } else if (line.compare(i + 1, 1, "x") == 0 && i + 3 < close) {
      word += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
      i += 3;
    } else if (line[i + 1] == '\\' || line[i + 1] == '"') {
      word += line[++i];
    } else {
      throw std::runtime_error(place + ": \\ stands before \\, \" or xNN");
    }
  }
  return word;
}

}  // namespace

std::vector<std::string> read_dictionary(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read the dictionary " + path);
  std::vector<std::string> words;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number)
    if (!line.empty() && line[0] != '#') words.push_back(unquoted(line, path + ":" + std::to_string(number)));
  return words;
}

}  // namespace ritz::fuzz
