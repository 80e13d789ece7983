#include "ritz/petsc/options.hpp"

#include <petscsys.h>

#include <fstream>
#include <sstream>

#include "ritz/base/error.hpp"
#include "ritz/parallel/comm.hpp"
#include "ritz/parallel/guard.hpp"
#include "ritz/petsc/check.hpp"
#include "ritz/petsc/csr.hpp"
#include "ritz/petsc/factorization.hpp"
#include "ritz/petsc/multigrid.hpp"

namespace ritz::petsc {
namespace {

bool is_yaml(const std::filesystem::path& file) { return file.extension() == ".yml" || file.extension() == ".yaml"; }

/// PETSc answers a wrong line with an error deep inside; this says it plainly first.
void check_line(const std::string& line, const std::string& place) {
  std::istringstream words(line);
  std::string name, value, rest;
  words >> name >> value >> rest;
  if (name.empty() || name[0] == '#') return;
  if (name[0] != '-')
    throw InputError(place + ": '" + name +
                     "' is no option; each line holds one, such as '-modes 20', or begins with #");
  if (name == "-options_file")
    throw InputError(place + ": one options file cannot name another; name both on the command line");
  if (value[0] != '#' && !rest.empty() && rest[0] != '#')
    throw InputError(place + ": option " + name + " takes one value; '" + rest + "' is a second");
}

void check_file(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (std::filesystem::is_directory(file) || !in)
    throw InputError("option -options_file " + file.string() + ": no such file, or it cannot be read");
  if (is_yaml(file)) return;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) check_line(line, file.string() + ":" + std::to_string(number));
}

}  // namespace

void insert_options_file(MPI_Comm comm, const std::filesystem::path& file) {
  parallel::on_root(comm, [&] { check_file(file); });
  // What the command line set is laid over the file's values again.
  char* all = nullptr;
  check(PetscOptionsGetAll(nullptr, &all));
  const std::string command_line = all;
  check(PetscFree(all));
  const auto insert = is_yaml(file) ? PetscOptionsInsertFileYAML : PetscOptionsInsertFile;
  if (!succeeds(insert(comm, nullptr, file.c_str(), PETSC_TRUE)))
    throw InputError("option -options_file " + file.string() + ": PETSc cannot make sense of that file");
  if (option_value("-options_file"))
    throw InputError(file.string() + ": one options file cannot name another; name both on the command line");
  check(PetscOptionsInsertString(nullptr, command_line.c_str()));
  PetscBool log = PETSC_FALSE;
  check(PetscOptionsHasName(nullptr, nullptr, "-log_view", &log));
  if (log) check(PetscLogDefaultBegin());
}

std::optional<std::string> option_value(const std::string& name) {
  PetscBool set = PETSC_FALSE;
  check(PetscOptionsHasName(nullptr, nullptr, name.c_str(), &set));
  if (!set) return std::nullopt;
  char value[4096] = "";
  PetscBool has_value = PETSC_FALSE;
  check(PetscOptionsGetString(nullptr, nullptr, name.c_str(), value, sizeof value, &has_value));
  return std::string(has_value ? value : "");
}

std::vector<std::pair<std::string, std::string>> unread_options() {
  PetscInt count = 0;
  char **names = nullptr, **values = nullptr;
  check(PetscOptionsLeftGet(nullptr, &count, &names, &values));
  std::vector<std::pair<std::string, std::string>> unread;
  for (PetscInt i = 0; i < count; ++i) unread.emplace_back(names[i], values[i] ? values[i] : "");
  check(PetscOptionsLeftRestore(nullptr, &count, &names, &values));
  return unread;
}

void read_factorization_options(MPI_Comm comm, const std::string& prefix) {
  const Matrix tiny = tiny_identity(comm);
  Factorization(comm, prefix).factor(tiny, tiny, 0);
}

void read_multigrid_options(MPI_Comm comm, const std::string& prefix) {
  const Matrix tiny = tiny_identity(comm);
  Multigrid(tiny, Tall::Identity(parallel::rank(comm) == 0 ? 3 : 0, 3), prefix);
}

}  // namespace ritz::petsc
