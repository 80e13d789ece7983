// Makes Eigen throw when it allocates while that is forbidden.
#pragma once
#include <stdexcept>

#define EIGEN_RUNTIME_NO_MALLOC
#define eigen_assert(x)                             \
  do {                                              \
    if (!(x)) throw std::logic_error("Eigen: " #x); \
  } while (false)
