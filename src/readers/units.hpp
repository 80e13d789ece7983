// Unit systems of mesh files. Everything inside ritz is in SI units.
#pragma once
#include <string>
#include <string_view>

#include "ritz/readers/file_mesh.hpp"

namespace ritz::readers {

/// The size of each unit in SI.
struct Units {
  std::string name = "m-kg-s";
  double length = 1;
  double mass = 1;
  double time = 1;

  double pressure() const { return mass / (length * time * time); }
  double density() const { return mass / (length * length * length); }
  FileMaterial to_si(FileMaterial m) const {
    if (m.young) *m.young *= pressure();
    if (m.density) *m.density *= density();
    if (m.law) m.law = fem::to_si(*m.law, pressure());
    return m;
  }
};

/// Parses length-mass-time, such as "m-kg-s", "mm-t-s", "um-kg-s", "mm-kg-ms" or "cm-g-s". Throws InputError for any
/// other word.
Units parse_units(std::string_view text);

}  // namespace ritz::readers
