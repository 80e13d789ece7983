// The text of an options file of the kind whose parser RITZ_FUZZ_OPTIONS names, read as ritz-reduce reads it, up to
// its plain structs; or as ritz-full, where it names a scene. No file is opened, and PETSc's options are gone when the
// input is done, so that no report is written.
#include <petscsys.h>

#include <algorithm>

#include "fuzz/parallel_setting.hpp"
#include "fuzz/target.hpp"
#include "ritz/config/config.hpp"
#include "ritz/config/options_text.hpp"

namespace ritz::fuzz {
namespace {

struct EmptyDatabase {
  EmptyDatabase() { PetscOptionsClear(nullptr); }
  ~EmptyDatabase() { PetscOptionsClear(nullptr); }
  EmptyDatabase(const EmptyDatabase&) = delete;
  EmptyDatabase& operator=(const EmptyDatabase&) = delete;
};

/// What PETSc will yet read, the reports: to stdout, or to a file whose name no shell and no decompressor sees.
void check_reports() {
  PetscInt count = 0;
  char **names = nullptr, **values = nullptr;
  PetscOptionsLeftGet(nullptr, &count, &names, &values);
  for (const std::string name : std::span(names, static_cast<std::size_t>(count)))
    for (const auto* part : {"dll_", "malloc", "on_error", "_shell", "debugger", "python", "options_"})
      if (name.find(part) != name.npos) finding("PETSc is given -" + name);
  for (const char* given : std::span(values, static_cast<std::size_t>(count))) {
    const std::string value = given ? given : "";
    if (value.find_first_of("|;&$`<>\'\"\\\n") != value.npos || value.ends_with(".gz") ||
        value.find(".gz:") != value.npos)
      finding("PETSc is given the value " + value);
  }
  PetscOptionsLeftRestore(nullptr, &count, &names, &values);
}

}  // namespace

void read_input(Bytes input) {
  static const algebra::Session session = start();
  const std::string text(input.begin(), input.end());
  if (text.find('\0') != text.npos) return;  // is refused where files are opened
  const EmptyDatabase around;
  auto options = config::RITZ_FUZZ_OPTIONS(text, "some options");
  config::Given given;
  given.put({"mesh", "box:1,1,1/1,1,1/tet4"});
  std::ranges::reverse(options);
  for (const auto& option : options) given.add(option);
  const bool has_scene =
      std::ranges::any_of(options, [](const auto& o) { return config::small_letters(o.name) == "scene"; });
  const auto config =
      config::read_config(session.comm(), given, has_scene ? config::Program::full : config::Program::reduce);
  check_reports();
  config::region_materials(config, {{.name = "box"}, {.name = "a b", .parts = {"a"}}});
}

}  // namespace ritz::fuzz
