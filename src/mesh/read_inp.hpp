// Abaqus's and CalculiX's .inp files, without parts and assemblies.
#pragma once
#include "ritz/mesh/read_source.hpp"

namespace ritz::mesh {

/// Reads source `file`. Keywords are obeyed, or change nothing that ritz computes, or are refused unless `ignored`
/// names them (read_inp_keywords.cpp); the supports are those of the first frequency step, else of the last step. A
/// solid section is a region named by its element set. A file without sections has one region a set of solid elements:
/// the first *ELSET that holds a cell, else the ELSET= of its *ELEMENT. A node set, an element set and a surface of the
/// same name are one set. Throws InputError.
FileMesh read_inp(Sources& sources, unsigned file, const Ignored& ignored);

}  // namespace ritz::mesh
