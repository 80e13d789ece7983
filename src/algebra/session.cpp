#include "ritz/algebra/session.hpp"

#include <dlfcn.h>
#include <slepceps.h>
#include <sys/resource.h>
#include <unistd.h>
// after PETSc itself, which it needs
#include <petscblaslapack.h>

#include <cstdlib>
#include <filesystem>
#include <new>
#include <vector>

#include "ritz/algebra/check.hpp"

namespace ritz::algebra {
namespace {

/// Variables that hold options for PETSc; it shall not find them.
std::vector<std::string> take_variables() {
  std::vector<std::string> taken;
  for (const char* name : {"PETSC_OPTIONS", "PETSC_OPTIONS_YAML"}) {
    if (const char* value = std::getenv(name); value && *value) taken.push_back(std::string("the variable ") + name);
    unsetenv(name);
  }
  return taken;
}

/// The files in which PETSc looks for options.
std::vector<std::string> petsc_files() {
  std::vector<std::filesystem::path> places = {".petscrc", "petscrc"};
  if (const char* home = std::getenv("HOME")) places.push_back(std::filesystem::path(home) / ".petscrc");
  std::vector<std::string> found;
  std::error_code none;
  for (const auto& place : places)
    if (std::filesystem::is_regular_file(place, none)) found.push_back("the file " + place.string());
  return found;
}

template <class Function>
Function symbol(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace

Session::Session(const std::string& program) : unread_(take_variables()) {
  std::string name = program, no_files = "-skip_petscrc";
  char* words[] = {name.data(), no_files.data(), nullptr};
  int count = 2;
  char** list = words;
  if (SlepcInitialize(&count, &list, nullptr, nullptr) != 0) std::exit(1);
  PetscPopSignalHandler();
  keep_messages();
  limit_blas_threads();
  check(PetscOptionsClear(nullptr));
  const auto files = petsc_files();
  unread_.insert(unread_.end(), files.begin(), files.end());
}

Session::~Session() {
  PetscOptionsSetValue(nullptr, "-options_left", "no");
  SlepcFinalize();
}

std::string loaded_blas() {
  if (const auto config = symbol<char* (*)()>("openblas_get_config")) return config();
  return "unknown (the reference BLAS is several times slower than OpenBLAS)";
}

bool blas_is_openblas() { return symbol<void*>("openblas_get_config") != nullptr; }

void limit_blas_threads() {
  if (std::getenv("OPENBLAS_NUM_THREADS") || std::getenv("OMP_NUM_THREADS")) return;
  if (const auto set = symbol<void (*)(int)>("openblas_set_num_threads")) set(1);
}

void restart_with_one_blas_thread(char** argv) {
  const auto threads = symbol<int (*)()>("openblas_get_num_threads");
  const char* asked = std::getenv("OPENBLAS_NUM_THREADS");
  rlimit space{};
  const bool limited = getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY;
  if (!limited || !threads || threads() == 1 || (asked && std::string(asked) == "1")) return;
  for (const char* name : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"}) setenv(name, "1", 1);
  execv("/proc/self/exe", argv);
}

void take_blas_memory() {
  constexpr std::size_t buffer = (std::size_t{128} << 20) + (std::size_t{1} << 20);  // OpenBLAS's, and some room
  constexpr PetscBLASInt n = 128;  // larger than what OpenBLAS multiplies without its buffer
  constexpr PetscScalar one = 1, zero = 0;
  std::vector<PetscScalar> a(std::size_t{n} * n), c(a.size());  // before the buffer's place is free again
  ::operator delete(::operator new(buffer));
  BLASgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, a.data(), &n, &zero, c.data(), &n);
}

std::vector<std::pair<std::string, std::string>> library_versions() {
  char petsc[256] = "", slepc[256] = "", mpi[MPI_MAX_LIBRARY_VERSION_STRING] = "";
  int length = 0;
  check(PetscGetVersion(petsc, sizeof petsc));
  check(SlepcGetVersion(slepc, sizeof slepc));
  MPI_Get_library_version(mpi, &length);
  const auto first_line = [](std::string s) { return s.substr(0, s.find_first_of(",\n")); };
  return {
      {"PETSc", first_line(petsc)}, {"SLEPc", first_line(slepc)}, {"MPI", first_line(mpi)}, {"BLAS", loaded_blas()}};
}

LogStage::LogStage(const std::string& name) {
  PetscLogStage stage = -1;
  check(PetscLogStageGetId(name.c_str(), &stage));
  if (stage < 0) check(PetscLogStageRegister(name.c_str(), &stage));
  check(PetscLogStagePush(stage));
}

LogStage::~LogStage() { PetscLogStagePop(); }

}  // namespace ritz::algebra
