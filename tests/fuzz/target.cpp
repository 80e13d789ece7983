#include "fuzz/target.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>

#include "ritz/base/error.hpp"

namespace ritz::fuzz {
namespace {

/// A folder of this process, gone when it ends.
struct Folder {
  std::filesystem::path path;
  Folder() {
    const std::filesystem::path memory = "/dev/shm";
    const auto parent = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    path = parent / ("ritz-fuzz-" + std::to_string(getpid()));
    std::filesystem::create_directories(path);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

}  // namespace

void finding(const std::string& what) {
  std::fprintf(stderr, "finding: %s\n", what.c_str());
  std::abort();
}

std::string outcome(Bytes input) {
  try {
    read_input(input);
    return {};
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (message.empty()) finding("a refusal without a message");
    return message;
  } catch (const std::exception& error) {
    finding(std::string("an exception that is no InputError: ") + error.what());
  } catch (...) {
    finding("an exception that is no std::exception");
  }
}

std::filesystem::path as_file(Bytes input, const std::string& name) {
  static const Folder folder;
  const auto path = folder.path / name;
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
  if (!out.flush()) finding("cannot write " + path.string());
  return path;
}

}  // namespace ritz::fuzz
