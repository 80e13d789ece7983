#include "ritz/config/command_line.hpp"

#include <cctype>
#include <string>

#include "ritz/base/error.hpp"
#include "ritz/petsc/options.hpp"

namespace ritz::config {
namespace {

/// PETSc's own rule: a dash and then no digit.
bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && !std::isdigit(static_cast<unsigned char>(word[1])) && word[1] != '.';
}

}  // namespace

Asked read_command_line(MPI_Comm comm, int argc, char** argv) {
  Asked asked = Asked::run;
  bool value_may_follow = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "-help" || word == "--help" || word == "-h") asked = Asked::help;
    if (!is_option(word) && !value_may_follow)
      throw InputError("'" + word + "' is not an option; options begin with a dash, such as -mesh " + word);
    value_may_follow = is_option(word);
    if (word == "-options_file_yaml")
      throw InputError("there is no option -options_file_yaml; give -options_file a file that ends in .yaml or .yml");
    if (word != "-options_file") continue;
    if (i + 1 == argc || is_option(argv[i + 1])) throw InputError("option -options_file needs a file after it");
    petsc::insert_options_file(comm, argv[i + 1]);
  }
  return asked;
}

std::vector<std::filesystem::path> option_files(int argc, char** argv) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i + 1 < argc; ++i)
    if (std::string(argv[i]) == "-options_file") files.emplace_back(argv[i + 1]);
  return files;
}

}  // namespace ritz::config
