#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "ritz/algebra/blas.hpp"

namespace ritz::algebra {
namespace {

template <class Function>
Function symbol(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

TEST(BlasThreads, AreOneARankUnlessTheUserSaysOtherwise) {
  const auto set = symbol<void (*)(int)>("openblas_set_num_threads");
  const auto get = symbol<int (*)()>("openblas_get_num_threads");
  if (!set || !get) GTEST_SKIP() << "the BLAS is not OpenBLAS";
  unsetenv("OPENBLAS_NUM_THREADS");
  unsetenv("OMP_NUM_THREADS");
  set(2);
  limit_blas_threads();
  EXPECT_EQ(get(), 1);
  for (const char* name : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"}) {
    setenv(name, "2", 1);
    set(2);
    limit_blas_threads();
    EXPECT_EQ(get(), 2) << name;
    unsetenv(name);
  }
  set(1);
}

}  // namespace
}  // namespace ritz::algebra
