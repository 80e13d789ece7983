// Uses the runtime alone: no file, no HDF5.
#include <cstdio>

#include "ritz/runtime/integrator.hpp"

using namespace ritz::runtime;

int main() { std::printf("%.15g\n", oscillator_step(exact(), StepKind::later, 4, 0, 1).A(0, 0)); }
