#include "fuzz/mutate.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

namespace ritz::fuzz {

namespace {

using Change = void (*)(std::string&, const Material&, Random&);

bool is_of_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e'; }

/// Some part of `text`: where it begins and how long it is, short ones more often.
std::pair<std::size_t, std::size_t> part_of(const std::string& text, Random& random) {
  const auto begin = random.below(text.size() + 1);
  const auto most = std::min(text.size() - begin, std::size_t{1} << random.below(12));
  return {begin, random.below(most + 1)};
}

/// The line around a random place, with its end.
std::pair<std::size_t, std::size_t> line_of(const std::string& text, Random& random) {
  const auto place = random.below(text.size() + 1);
  const auto before = place == 0 ? std::string::npos : text.rfind('\n', place - 1);
  const auto begin = before == std::string::npos ? 0 : before + 1;
  const auto end = text.find('\n', begin);
  return {begin, (end == std::string::npos ? text.size() : end + 1) - begin};
}

void flip_bit(std::string& text, const Material&, Random& random) {
  if (text.empty()) return;
  char& c = text[random.below(text.size())];
  c = static_cast<char>(static_cast<unsigned char>(c) ^ (1u << random.below(8)));
}

void set_byte(std::string& text, const Material&, Random& random) {
  if (text.empty()) return;
  // Half of the time a byte from elsewhere in the file, so that letters stay letters.
  text[random.below(text.size())] =
      random.below(2) == 0 ? text[random.below(text.size())] : static_cast<char>(random.below(256));
}

/// Binary numbers: 1, 2, 4 or 8 bytes of an extreme value.
void set_binary_number(std::string& text, const Material&, Random& random) {
  constexpr std::array<std::uint64_t, 8> values = {0,          1,          ~std::uint64_t{0},  0x7fffffffffffffff,
                                                   0x7fffffff, 0x80000000, 0x7ff8000000000000, 0x0000000100000000};
  const auto size = std::size_t{1} << random.below(4);
  if (text.size() < size) return;
  const auto value = random.below(2) == 0 ? values[random.below(values.size())] : random.below(300);
  const auto at = random.below(text.size() - size + 1);
  for (std::size_t i = 0; i < size; ++i) text[at + i] = static_cast<char>(value >> (8 * i) & 255);
}

void edit_number(std::string& text, const Material&, Random& random) {
  static const std::array<std::string, 22> values = {"0",
                                                     "-1",
                                                     "1",
                                                     "2",
                                                     "1e308",
                                                     "-1e308",
                                                     "1e-320",
                                                     "nan",
                                                     "inf",
                                                     "2147483647",
                                                     "2147483648",
                                                     "4294967296",
                                                     "9223372036854775807",
                                                     "-9223372036854775808",
                                                     "18446744073709551616",
                                                     "1e12",
                                                     "1e999",
                                                     "0x10",
                                                     "1.",
                                                     ".",
                                                     "1,2",
                                                     "00000000000000000000000001"};
  if (text.empty()) return;
  const auto from = random.below(text.size());
  const auto begin = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(), is_of_number);
  if (begin == text.end()) return;
  const auto end = std::find_if_not(begin, text.end(), is_of_number);
  text.replace(begin, end, values[random.below(values.size())]);
}

void cut_end(std::string& text, const Material&, Random& random) { text.resize(random.below(text.size() + 1)); }

void erase_part(std::string& text, const Material&, Random& random) {
  const auto [begin, length] = part_of(text, random);
  text.erase(begin, length);
}

void insert_word(std::string& text, const Material& material, Random& random) {
  if (material.words.empty()) return;
  text.insert(random.below(text.size() + 1), material.words[random.below(material.words.size())]);
}

void overwrite_by_word(std::string& text, const Material& material, Random& random) {
  if (material.words.empty()) return;
  const auto& word = material.words[random.below(material.words.size())];
  const auto at = random.below(text.size() + 1);
  text.replace(at, std::min(word.size(), text.size() - at), word);
}

void insert_from_other(std::string& text, const Material& material, Random& random) {
  const auto& other = material.pool[random.below(material.pool.size())];
  const auto [begin, length] = part_of(other, random);
  text.insert(random.below(text.size() + 1), other.substr(begin, length));
}

void splice(std::string& text, const Material& material, Random& random) {
  const auto& other = material.pool[random.below(material.pool.size())];
  text.resize(random.below(text.size() + 1));
  text += other.substr(random.below(other.size() + 1));
}

void erase_line(std::string& text, const Material&, Random& random) {
  const auto [begin, length] = line_of(text, random);
  text.erase(begin, length);
}

void repeat_line(std::string& text, const Material&, Random& random) {
  const auto [begin, length] = line_of(text, random);
  const auto line = text.substr(begin, length);
  text.insert(begin, line);
}

void move_line(std::string& text, const Material&, Random& random) {
  const auto [begin, length] = line_of(text, random);
  const auto line = text.substr(begin, length);
  text.erase(begin, length);
  text.insert(line_of(text, random).first, line);
}

/// The same few bytes very often, as nested brackets and long lists are made.
void repeat_part(std::string& text, const Material& material, Random& random) {
  const auto [begin, length] = part_of(text, random);
  auto part = text.substr(begin, std::min<std::size_t>(length, 64));
  if (!material.words.empty() && random.below(2) == 0) part = material.words[random.below(material.words.size())];
  std::string many;
  for (auto times = std::size_t{1} << random.below(16); times > 0 && many.size() < most_bytes; --times) many += part;
  text.insert(begin, many);
}

constexpr std::array<Change, 14> changes = {flip_bit,    set_byte,          set_binary_number, edit_number, edit_number,
                                            cut_end,     erase_part,        insert_word,       splice,      erase_line,
                                            repeat_line, overwrite_by_word, insert_from_other, move_line};

}  // namespace

std::string mutated(const Material& material, Random& random) {
  std::string text = material.pool[random.below(material.pool.size())];
  for (auto left = 1 + random.below(4); left > 0; --left) {
    constexpr std::size_t seldom = 40;  // long inputs take long
    if (random.below(seldom) == 0) repeat_part(text, material, random);
    else changes[random.below(changes.size())](text, material, random);
  }
  if (text.size() > most_bytes) text.resize(most_bytes);
  return text;
}

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
