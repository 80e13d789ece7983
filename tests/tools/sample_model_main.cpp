// Writes the sample model, for tests that run programs: sample_model PATH.
#include <iostream>

#include "ritz/format/parts.hpp"
#include "support/sample_model.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  ritz::format::write(argv[1], ritz::test::sample_model());
  return 0;
}
