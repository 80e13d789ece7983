// interrupted NAME before|during|after: has a half-written NAME, says "ready" and waits: before its files get their
// names, while they do, or after.
#include <unistd.h>

#include <cstdio>
#include <string_view>

#include "ritz/files/claim.hpp"
#include "ritz/files/interruption.hpp"
#include "ritz/files/part_file.hpp"

namespace {

void wait() {
  std::puts("ready");
  std::fflush(stdout);
  ::usleep(300'000);
}

}  // namespace

int main(int, char** argv) {
  using namespace ritz::files;
  const std::string_view when = argv[2];
  watch_interruptions("interrupted");
  const Claim claim({.outputs = {{"the output", argv[1]}, {"its table", std::string(argv[1]) + ".csv"}}});
  PartFile output(argv[1]), table(std::string(argv[1]) + ".csv");
  output.write("new");
  table.write("new");
  if (when == "before") wait();
  {
    const Uninterrupted together;
    output.publish();
    if (when == "during") wait();
    table.publish();
    claim.say_published();
  }
  if (when == "after") wait();
  std::puts("ended");
}
