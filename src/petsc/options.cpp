#include "ritz/petsc/options.hpp"

#include <petscsys.h>

#include "ritz/parallel/comm.hpp"
#include "ritz/petsc/check.hpp"
#include "ritz/petsc/csr.hpp"
#include "ritz/petsc/factorization.hpp"
#include "ritz/petsc/multigrid.hpp"

namespace ritz::petsc {
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
