// write_sample_model FILE [NOTES | two-bodies]: the sample as a file, with a report of so many notes when it is to be
// large, or with a second body.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "ritz/format/parts.hpp"
#include "support/nonlinear_sample_model.hpp"

int main(int argc, char** argv) {
  if (argc < 2) return std::fputs("usage: write_sample_model FILE [NOTES | two-bodies]\n", stderr), 2;
  const bool two = argc > 2 && argv[2] == std::string_view("two-bodies");
  auto model = two ? ritz::test::two_body_model() : ritz::test::sample_model();
  if (argc > 2 && !two)
    model.bodies[0].report.notes.assign(std::strtoul(argv[2], nullptr, 10), "a note like any other");
  try {
    ritz::format::write(argv[1], model);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
