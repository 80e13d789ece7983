#include "ritz/algebra/options.hpp"

#include <petscsys.h>

#include "ritz/algebra/check.hpp"
#include "ritz/algebra/csr.hpp"
#include "ritz/algebra/factorization.hpp"
#include "ritz/algebra/multigrid.hpp"
#include "ritz/parallel/comm.hpp"

namespace ritz::algebra {
void set_option(const std::string& name, const std::string& value) {
  check(PetscOptionsSetValue(nullptr, ("-" + name).c_str(), value.empty() ? nullptr : value.c_str()));
}

void clear_option(const std::string& name) { check(PetscOptionsClearValue(nullptr, ("-" + name).c_str())); }

std::vector<std::string> unread_options() {
  PetscInt count = 0;
  char **names = nullptr, **values = nullptr;
  check(PetscOptionsLeftGet(nullptr, &count, &names, &values));
  const std::vector<std::string> unread(names, names + count);
  check(PetscOptionsLeftRestore(nullptr, &count, &names, &values));
  return unread;
}

void begin_log(Log log) { check(log == Log::nested ? PetscLogNestedBegin() : PetscLogDefaultBegin()); }

void read_factorization_options(MPI_Comm comm, const std::string& prefix) {
  const Matrix tiny = tiny_identity(comm);
  Factorization(comm, prefix).factor(tiny, tiny, 0);
}

void read_multigrid_options(MPI_Comm comm, const std::string& prefix) {
  const Matrix tiny = tiny_identity(comm);
  Multigrid(tiny, Tall::Identity(parallel::rank(comm) == 0 ? 3 : 0, 3), prefix);
}

}  // namespace ritz::algebra
