#include "ritz/config/options_text.hpp"

#include <cctype>
#include <sstream>

#include "ritz/base/error.hpp"

namespace ritz::config {
namespace {

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// A word of a line, and whether any of it stood in quotes.
struct QuotedWord {
  std::string text;
  bool quoted = false;
};

/// As a shell reads them: blanks part words, quotes of either kind keep them, # before a word begins a comment.
std::vector<QuotedWord> words_of(const std::string& line, const std::string& place) {
  std::vector<QuotedWord> words;
  bool within = false;
  char quote = 0;
  for (const char c : line) {
    if (!quote && is_blank(c)) within = false;
    else if (!quote && !within && c == '#') break;
    else {
      if (!within) words.emplace_back();
      within = true;
      if (quote ? c == quote : c == '"' || c == '\'') {
        quote = quote ? '\0' : c;
        words.back().quoted = true;
      } else {
        words.back().text += c;
      }
    }
  }
  if (quote) throw InputError(place + ": the quote that " + std::string(1, quote) + " opens is not closed");
  return words;
}

/// Adds the option that a line states, if it does.
void read_line(const std::string& line, const std::string& place, std::vector<Option>& options) {
  const auto words = words_of(line, place);
  if (words.empty()) return;
  const std::string& name = words[0].text;
  if (name.size() < 2 || name[0] != '-')
    throw InputError(place + ": '" + name +
                     "' is no option; each line holds one, such as '-modes 20', or begins with #");
  if (words.size() > 1 && !words[1].quoted && is_option(words[1].text))
    throw InputError(place + ": each line holds one option; '" + words[1].text + "' is a second");
  if (words.size() > 2)
    throw InputError(place + ": option " + name + " takes one value; '" + words[2].text +
                     "' is a second (a name with blanks in it stands in quotes)");
  refuse_file_in_file(name.substr(1), place);
  options.push_back({name.substr(1), words.size() > 1 ? words[1].text : ""});
}

}  // namespace

void refuse_file_in_file(const std::string& name, const std::string& place) {
  if (small_letters(name) == "options_file")
    throw InputError(place + ": one options file cannot name another; name both on the command line");
}

bool is_option(std::string_view word) {
  return word.size() > 1 && word[0] == '-' && !std::isdigit(static_cast<unsigned char>(word[1])) && word[1] != '.';
}

std::vector<Option> parse_plain_options(const std::string& text, const std::string& file) {
  constexpr std::string_view mark = "\xef\xbb\xbf";  // of UTF-8, as editors of Windows write it
  std::vector<Option> options;
  std::istringstream in(text.starts_with(mark) ? text.substr(mark.size()) : text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) read_line(line, file + ":" + std::to_string(number), options);
  return options;
}

}  // namespace ritz::config
