// The reader of each format. It reads file number `file` of `sources`, and all files that this one includes. What
// `ignored` names is left out. Every reader throws an InputError that names file and line.
#pragma once
#include "ritz/readers/source.hpp"

namespace ritz::readers {

/// Gmsh's .msh files, versions 2.2 and 4.1, text and binary. A physical volume is a region and a set; the other
/// physical groups are sets; a group without a name is named by its number. A cell in several physical volumes belongs
/// to the region listed first. A set that volumes share a name with is the one of lower dimension.
FileMesh read_msh(Sources& sources, unsigned file, const Ignored& ignored);

/// Vega FEM's .veg files, with vertices and elements numbered from 0 or from 1. A region is named by its set; where
/// regions overlap the later one takes precedence. allElements is always a set.
FileMesh read_veg(Sources& sources, unsigned file, const Ignored& ignored);

/// Abaqus's and CalculiX's .inp files, without parts and assemblies. A keyword is obeyed, or is skipped because it
/// changes nothing that ritz computes, or is refused unless `ignored` names it (inp_keywords.cpp). The supports are
/// those of the first frequency step, or else of the last step. A solid section is a region named by its element set. A
/// file without sections has one region for each set of solid elements: the first *ELSET that contains a cell, or else
/// the ELSET= of its *ELEMENT. A node set, an element set and a surface of the same name are one set.
FileMesh read_inp(Sources& sources, unsigned file, const Ignored& ignored);

/// VTK's unstructured grids in XML, .vtu. The pieces of a file are concatenated; vertices and cells are numbered from
/// 0. An integer cell array called region, Region, gmsh:physical, medit:ref, MaterialID or cell_tags gives regions (and
/// sets) named by its values; a point array of 8-bit integers gives the set of its non-zero vertices.
FileMesh read_vtu(Sources& sources, unsigned file, const Ignored& ignored);

}  // namespace ritz::readers
