// Uses the runtime alone: no file, no HDF5.
#include <cstdio>

#include "ritz/runtime/integrators.hpp"

int main() { std::printf("%.15g\n", ritz::runtime::exact().step(4, 0, 1).A(0, 0)); }
