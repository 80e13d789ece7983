// A command line as a program of ours would read it.
#pragma once
#include <petscsys.h>

#include <string>
#include <vector>

#include "ritz/algebra/check.hpp"
#include "ritz/config/command_line.hpp"
#include "ritz/config/config.hpp"

namespace ritz::config::testing {

/// The words after the program's name; what a run before left in PETSc's database is gone. *Collective*.
inline Config configured(std::vector<std::string> words) {
  static const bool quiet = (algebra::keep_messages(), true);
  (void)quiet;
  words.insert(words.begin(), "ritz-reduce");
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  PetscOptionsClear(nullptr);
  return read_config(MPI_COMM_WORLD,
                     read_command_line(MPI_COMM_WORLD, static_cast<int>(pointers.size()), pointers.data()).given);
}

/// A command line on a box, and more.
inline Config with_box(std::vector<std::string> more) {
  more.insert(more.begin(), {"-mesh", "box:1,1,1/2,2,2/tet4"});
  return configured(std::move(more));
}

}  // namespace ritz::config::testing
