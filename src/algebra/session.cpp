#include "ritz/algebra/session.hpp"

#include <malloc.h>
#include <slepceps.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "ritz/algebra/blas.hpp"
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

/// Ranks that mpirun has started on one machine meet in its memory, as MPI finds out after a search for networks and
/// displays that takes longer than the modes of a small model. What the user asks of MPI stays.
void spare_the_search_for_networks() {
  const char *all = std::getenv("OMPI_COMM_WORLD_SIZE"), *here = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  if (!all || !here || std::string(all) != here) return;
  setenv("OMPI_MCA_pml", "ob1", 0);
  setenv("HWLOC_COMPONENTS", "-gl", 0);
}

/// SuperLU_DIST, which PETSc brings along, forbids malloc as it is loaded to give any memory back to the system.
void give_memory_back() {
#ifdef __GLIBC__
  constexpr int large = 16 << 20;  // to clear pages anew for smaller ones takes longer than they are worth
  mallopt(M_MMAP_MAX, 1 << 16);
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, 2 * large);
#endif
}

}  // namespace

Session::Session(const std::string& program) : unread_(take_variables()) {
  spare_the_search_for_networks();
  give_memory_back();
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
