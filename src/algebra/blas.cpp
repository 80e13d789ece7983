#include "ritz/algebra/blas.hpp"

#include <dlfcn.h>
#include <petscsys.h>
#include <sys/resource.h>
#include <unistd.h>
// after PETSc itself, which it needs
#include <petscblaslapack.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

namespace ritz::algebra {
namespace {

using Variables = std::vector<std::pair<const char*, const char*>>;

template <class Function>
Function symbol(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

/// What keeps OpenBLAS from starting threads in an address space that is too small for them.
Variables one_thread() {
  const auto threads = symbol<int (*)()>("openblas_get_num_threads");
  const char* asked = std::getenv("OPENBLAS_NUM_THREADS");
  rlimit space{};
  const bool limited = getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY;
  if (!limited || !threads || threads() == 1 || (asked && std::string(asked) == "1")) return {};
  return {{"OPENBLAS_NUM_THREADS", "1"}, {"OMP_NUM_THREADS", "1"}};
}

/// The best kernels that this processor can run; null where those for SSE are.
const char* best_kernels() {
#if defined(__x86_64__) && defined(__GNUC__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "Haswell";
#endif
  return nullptr;
}

/// What makes OpenBLAS take these kernels where it took old ones.
Variables kernels() {
  const auto taken = symbol<char* (*)()>("openblas_get_corename");
  if (!taken || std::getenv("OPENBLAS_CORETYPE")) return {};
  constexpr std::array old = {"Prescott", "Core2", "Nehalem", "Barcelona"};
  const bool outdated = std::ranges::find(old, std::string(taken())) != old.end();
  const char* best = best_kernels();
  if (!outdated || !best) return {};
  return {{"OPENBLAS_CORETYPE", best}};
}

}  // namespace

std::string loaded_blas() {
  if (const auto config = symbol<char* (*)()>("openblas_get_config")) return config();
  return "unknown (the reference BLAS is several times slower than OpenBLAS)";
}

bool blas_is_openblas() { return symbol<void*>("openblas_get_config") != nullptr; }

void limit_blas_threads() {
  if (std::getenv("OPENBLAS_NUM_THREADS") || std::getenv("OMP_NUM_THREADS")) return;
  if (const auto set = symbol<void (*)(int)>("openblas_set_num_threads")) set(1);
}

void restart_with_fitting_blas(char** argv) {
  Variables wanted = one_thread();
  for (const auto& variable : kernels()) wanted.push_back(variable);
  if (wanted.empty()) return;
  for (const auto& [name, value] : wanted) setenv(name, value, 1);
  execv("/proc/self/exe", argv);
}

void take_blas_memory() {
  constexpr std::size_t buffer = (std::size_t{128} << 20) + (std::size_t{1} << 20);  // OpenBLAS's, and some room
  constexpr PetscBLASInt n = 128;  // larger than what OpenBLAS multiplies without its buffer
  constexpr PetscScalar one = 1, zero = 0;
  std::vector<PetscScalar> a(std::size_t{n} * n), c(a.size());  // before the buffer's place is free again
  ::operator delete(::operator new(buffer));
  BLASgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, a.data(), &n, &zero, c.data(), &n);
}

}  // namespace ritz::algebra
