// fuzz_seeds FOLDER: the seeds that are made rather than kept, FOLDER/TARGET/NAME each.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "ritz/format/parts.hpp"
#include "support/nonlinear_sample_model.hpp"
#ifdef RITZ_FUZZ_MESHES
#include "mesh/reader_fixture.hpp"
#endif

namespace {

void put_models(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "model");
  ritz::format::write(folder / "model" / "linear", ritz::test::sample_model());
  ritz::format::write(folder / "model" / "nonlinear", ritz::test::nonlinear_sample_model());
}

#ifdef RITZ_FUZZ_MESHES
void put_meshes(const std::filesystem::path& folder) {
  for (const auto& [label, name, bytes] : ritz::mesh::testing::good_files()) {
    const auto to = folder / name.substr(name.rfind('.') + 1);
    std::filesystem::create_directories(to);
    std::ofstream(to / label, std::ios::binary) << bytes;
  }
}
#endif

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("usage: fuzz_seeds FOLDER\n", stderr), 2;
  const std::filesystem::path folder = argv[1];
  try {
    put_models(folder);
#ifdef RITZ_FUZZ_MESHES
    put_meshes(folder);
#endif
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fuzz_seeds: %s\n", error.what());
    return 1;
  }
}
