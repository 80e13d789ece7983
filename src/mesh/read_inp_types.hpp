// The element types of Abaqus and CalculiX.
#pragma once
#include <string>
#include <vector>

#include "ritz/mesh/read_listed.hpp"

namespace ritz::mesh {

/// What ritz makes of an element type: its own element, its own in place of another formulation (with a note, or only
/// on the user's word), or nothing.
enum class InpReading { same, noted, on_your_word, none };

struct InpType {
  InpReading reading;
  Shape shape;        ///< of all but `none`
  std::string plain;  ///< the type that it is read as: "C3D8"
  std::string formulation;
};

/// `name` in capitals. Elements of lower dimension only carry sets.
InpType inp_type(const std::string& name);

/// The words by which -ignore leaves elements of an unread type out: the keyword that gives them their properties
/// ("SPRING" for SPRINGA), if there is one, and the type.
std::vector<std::string> words_of_type(const std::string& name);

}  // namespace ritz::mesh
