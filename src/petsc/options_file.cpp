#include <petscsys.h>

#include <cctype>
#include <fstream>
#include <sstream>

#include "ritz/base/error.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"
#include "ritz/petsc/check.hpp"
#include "ritz/petsc/options.hpp"

namespace ritz::petsc {
namespace {

using Options = std::vector<std::pair<std::string, std::optional<std::string>>>;

bool is_yaml(const std::filesystem::path& file) { return file.extension() == ".yml" || file.extension() == ".yaml"; }

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// A word of a line, and whether any of it stood in quotes.
struct Word {
  std::string text;
  bool quoted = false;
};

/// As a shell reads them: blanks part words, quotes of either kind keep them, # before a word begins a comment.
std::vector<Word> words_of(const std::string& line, const std::string& place) {
  std::vector<Word> words;
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

bool is_option(const Word& word) {
  return !word.quoted && word.text.size() > 1 && word.text[0] == '-' &&
         !std::isdigit(static_cast<unsigned char>(word.text[1])) && word.text[1] != '.';
}

/// Adds the option that a line states, if it does.
void read_line(const std::string& line, const std::string& place, Options& options) {
  const auto words = words_of(line, place);
  if (words.empty()) return;
  const std::string& name = words[0].text;
  if (name.size() < 2 || name[0] != '-')
    throw InputError(place + ": '" + name +
                     "' is no option; each line holds one, such as '-modes 20', or begins with #");
  if (name == "-options_file")
    throw InputError(place + ": one options file cannot name another; name both on the command line");
  if (words.size() > 1 && is_option(words[1]))
    throw InputError(place + ": each line holds one option; '" + words[1].text + "' is a second");
  if (words.size() > 2)
    throw InputError(place + ": option " + name + " takes one value; '" + words[2].text +
                     "' is a second (a name with blanks in it stands in quotes)");
  options.emplace_back(name, words.size() > 1 ? std::optional(words[1].text) : std::nullopt);
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (std::filesystem::is_directory(file) || !in)
    throw InputError("option -options_file " + file.string() + ": no such file, or it cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

Options read_plain(const std::string& text, const std::filesystem::path& file) {
  Options options;
  std::istringstream in(text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number)
    read_line(line, file.string() + ":" + std::to_string(number), options);
  return options;
}

/// *Collective*.
Options read_yaml(MPI_Comm comm, const std::filesystem::path& file) {
  PetscOptions database = nullptr;
  check(PetscOptionsCreate(&database));
  const bool sound = succeeds(PetscOptionsInsertFileYAML(comm, database, file.c_str(), PETSC_TRUE));
  PetscInt count = 0;
  char **names = nullptr, **values = nullptr;
  check(PetscOptionsLeftGet(database, &count, &names, &values));
  Options options;
  for (PetscInt i = 0; i < count; ++i)
    options.emplace_back(std::string("-") + names[i], values[i] ? std::optional<std::string>(values[i]) : std::nullopt);
  check(PetscOptionsLeftRestore(database, &count, &names, &values));
  check(PetscOptionsDestroy(&database));
  if (!sound) throw InputError("option -options_file " + file.string() + ": PETSc cannot make sense of that file");
  for (const auto& [name, value] : options)
    if (name == "-options_file")
      throw InputError(file.string() + ": one options file cannot name another; name both on the command line");
  return options;
}

void set(const std::string& name, const std::optional<std::string>& value) {
  check(PetscOptionsSetValue(nullptr, name.c_str(), value ? value->c_str() : nullptr));
}

/// Whether PETSc has read the option already, while it started: then it was set before.
bool is_used(const std::string& name) {
  PetscBool used = PETSC_FALSE;
  check(PetscOptionsUsed(nullptr, name.c_str() + 1, &used));
  return used == PETSC_TRUE;
}

}  // namespace

void insert_options_file(MPI_Comm comm, const std::filesystem::path& file) {
  std::string text;
  parallel::on_root(comm, [&] {
    text = text_of(file);
    if (!is_yaml(file)) read_plain(text, file);
  });
  parallel::broadcast(comm, text);
  const Options options = is_yaml(file) ? read_yaml(comm, file) : read_plain(text, file);
  const auto before = unread_options();
  for (const auto& [name, value] : options)
    if (!is_used(name)) set(name, value);
  // What was set before is laid over the file's values again.
  for (const auto& [name, value] : before) set("-" + name, value.empty() ? std::nullopt : std::optional(value));
  PetscBool log = PETSC_FALSE;
  check(PetscOptionsHasName(nullptr, nullptr, "-log_view", &log));
  if (log) check(PetscLogDefaultBegin());
}

}  // namespace ritz::petsc
