#include "ritz/config/solver_options.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <sstream>
#include <tuple>

#include "ritz/base/error.hpp"
#include "ritz/base/nearest.hpp"
#include "ritz/base/printable.hpp"

namespace ritz::config {
namespace {

constexpr std::size_t longest_word = 200;  // PETSc cuts longer ones in silence

struct Rule {
  SolverOption kind;
  std::vector<std::string> words;  ///< of a type; empty: any word
};

using Rules = std::map<std::string, Rule>;

std::vector<std::string> split(std::string_view text) {
  std::istringstream in{std::string(text)};
  return {std::istream_iterator<std::string>(in), {}};
}

/// An option without a prefix is PETSc's own.
std::vector<std::string> prefixes_of(const SolverNames& group) {
  return group.prefixes.empty() ? std::vector<std::string>{""} : split(group.prefixes);
}

Rules make_rules() {
  Rules rules;
  for (const SolverNames& group : solver_names())
    for (const auto& prefix : prefixes_of(group))
      for (const auto& name : split(group.names)) rules[prefix + name] = {group.kind, split(group.words)};
  return rules;
}

const Rules& rules() {
  static const Rules rules = make_rules();
  return rules;
}

bool consists_of(std::string_view text, std::string_view marks) {
  return std::ranges::all_of(text, [&](unsigned char c) {
    return (c < 128 && std::isalnum(c)) || marks.find(static_cast<char>(c)) != marks.npos;
  });
}

[[noreturn]] void refuse(const Option& option, const std::string& why) {
  throw InputError("option -" + option.name + " " + printable(option.value.substr(0, longest_word)) + ": " + why);
}

bool is_plain(const std::string& file) {
  const std::string end = small_letters(std::filesystem::path(file).extension().string());
  return file.size() <= longest_word && consists_of(file, "._-+=@,/ ") && !file.starts_with('-') && file != "stderr" &&
         end != ".gz" && end != ".z" && end != ".bz2";
}

}  // namespace

std::optional<SolverOption> solver_option(const std::string& name) {
  const auto found = rules().find(small_letters(name));
  return found == rules().end() ? std::nullopt : std::optional(found->second.kind);
}

const std::vector<std::string>& solver_option_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> names;
    for (const auto& [name, rule] : rules()) names.push_back(name);
    return names;
  }();
  return names;
}

void check_setting(const Option& option) {
  const auto& words = rules().at(small_letters(option.name)).words;
  if (option.value.size() > longest_word || !consists_of(option.value, ".,+-_"))
    refuse(option, "that is neither a number nor a word that PETSc knows");
  if (words.empty() || std::ranges::find(words, option.value) != words.end()) return;
  std::string list;
  for (const auto& word : words) list += (list.empty() ? "" : ", ") + word;
  refuse(option, "that is not one of " + list + guess(option.value, words));
}

Report parse_report(const Option& option, const std::vector<std::string>& formats) {
  std::vector<std::string> parts;
  std::istringstream in(option.value);
  for (std::string part; std::getline(in, part, ':');) parts.push_back(part);
  parts.resize(std::max<std::size_t>(parts.size(), 4));
  if (parts[0] == "stdout") parts[0] = "ascii";
  if (parts[1] == "stdout") parts[1] = "";
  const auto& [file, format, mode] = std::tie(parts[1], parts[2], parts[3]);
  if (parts.size() > 4 || (!parts[0].empty() && parts[0] != "ascii") || (!mode.empty() && mode != "append"))
    refuse(option, "a report goes to stdout, or to a file by :FILE or :FILE:FORMAT");
  if (!is_plain(file))
    refuse(option,
           "the file of a report has a plain name, of letters, digits and ._-+=@, alone, and is not compressed");
  if (!format.empty() && std::ranges::find(formats, format) == formats.end())
    refuse(option, formats.empty() ? "that report has one format; leave '" + format + "' out"
                                   : "there is no such format" + hint(format, formats));
  const bool usual = file.empty() && format.empty();
  return {file, format, usual ? "" : "ascii:" + file + ":" + format + (mode.empty() ? "" : ":" + mode)};
}

}  // namespace ritz::config
