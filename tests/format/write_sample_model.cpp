// write_sample_model FILE [NOTES]: the sample as a file, with a report of so many notes when it is to be large.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "ritz/format/parts.hpp"
#include "support/sample_model.hpp"

int main(int argc, char** argv) {
  if (argc < 2) return std::fputs("usage: write_sample_model FILE [NOTES]\n", stderr), 2;
  auto model = ritz::test::sample_model();
  if (argc > 2) model.report.notes.assign(std::strtoul(argv[2], nullptr, 10), "a note like any other");
  try {
    ritz::format::write(argv[1], model);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
