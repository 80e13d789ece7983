// fuzz_seeds FOLDER: the seeds that are made rather than kept, FOLDER/TARGET/NAME each.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "ritz/format/parts.hpp"
#include "support/nonlinear_sample_model.hpp"
#ifdef RITZ_FUZZ_MESHES
#include "readers/fixture.hpp"
#endif

namespace {

void put(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string repeated(const std::string& part, std::size_t times) {
  std::string all;
  while (times-- > 0) all += part;
  return all;
}

/// What goes deeper than any stack, or than a parser of quadratic time can follow.
void put_deep_texts(const std::filesystem::path& folder) {
  constexpr std::size_t deep = 32000;
  put(folder / "scene" / "deep key", repeated("a.", deep) + "a = 1\n");
  put(folder / "scene" / "deep section", "[" + repeated("a.", deep) + "a]\n");
  put(folder / "scene" / "deep table", "a = " + repeated("{a=", deep) + "\n");
  put(folder / "scene" / "deep array", "a = " + repeated("[", deep) + "\n");
  put(folder / "yaml" / "deep list", repeated("[", 2 * deep));
  put(folder / "yaml" / "deep map", repeated("{a: ", deep / 2));
  put(folder / "yaml" / "deep block", "a: " + repeated("- ", deep));
}

/// Models whose global heap (HDF5 1.10 keeps no checksum of it) is damaged at one place each.
void put_damaged_heaps(const std::filesystem::path& folder) {
  std::ifstream in(folder / "nonlinear", std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  const auto heap = whole.find("GCOL");
  constexpr std::size_t places = 24, width = 8;
  for (std::size_t i = 0; heap != std::string::npos && i < places; ++i) {
    auto damaged = whole;
    const auto at = heap + width * i;
    if (at + width > damaged.size()) return;
    for (const char byte : {'\xff', '\0'}) {
      damaged.replace(at, width, std::string(width, byte));
      put(folder / ("heap " + std::to_string(i) + (byte == 0 ? " zeros" : " ones")), damaged);
    }
  }
}

void put_models(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "model");
  ritz::format::write(folder / "model" / "linear", ritz::test::sample_model());
  ritz::format::write(folder / "model" / "nonlinear", ritz::test::nonlinear_sample_model());
  ritz::format::write(folder / "model" / "cubature", ritz::test::cubature_sample_model());
  ritz::format::write(folder / "model" / "two bodies", ritz::test::two_body_model());
  put_damaged_heaps(folder / "model");
}

#ifdef RITZ_FUZZ_MESHES
void put_meshes(const std::filesystem::path& folder) {
  for (const auto& [label, name, bytes] : ritz::readers::testing::good_files()) {
    put(folder / name.substr(name.rfind('.') + 1) / label, bytes);
  }
}
#endif

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("usage: fuzz_seeds FOLDER\n", stderr), 2;
  const std::filesystem::path folder = argv[1];
  try {
    put_deep_texts(folder);
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
