// The reader of each format: reads file number `file` of `sources`, and whatever files that one includes. What
// `ignored` names is left out on the user's word. Every reader throws InputError, which names file and line.
#pragma once
#include "ritz/readers/source.hpp"

namespace ritz::readers {

/// Gmsh's .msh files, versions 2.2 and 4.1, text and binary. A physical volume is a region and a set; the other
/// physical groups are sets; a group without a name is named by its number. A cell in several physical volumes belongs
/// to the region listed first. A set that volumes share a name with is the one of lower dimension.
FileMesh read_msh(Sources& sources, unsigned file, const Ignored& ignored);

/// Vega FEM's .veg files, their vertices and elements numbered from 0 or from 1. A region is named by its set, and
/// where regions overlap the later one wins; allElements is always a set.
FileMesh read_veg(Sources& sources, unsigned file, const Ignored& ignored);

/// Abaqus's and CalculiX's .inp files, without parts and assemblies. Keywords are obeyed, or change nothing that ritz
/// computes, or are refused unless `ignored` names them (inp_keywords.cpp); the supports are those of the first
/// frequency step, else of the last step. A solid section is a region named by its element set. A file without sections
/// has one region for each set of solid elements: the first *ELSET that holds a cell, else the ELSET= of its *ELEMENT.
/// A node set, an element set and a surface of the same name are one set.
FileMesh read_inp(Sources& sources, unsigned file, const Ignored& ignored);

/// VTK's unstructured grids in XML, .vtu; the pieces of a file are put one after the other. Vertices and cells are
/// numbered from 0. An integer cell array named region, Region, gmsh:physical, medit:ref, MaterialID or cell_tags makes
/// regions (and sets) named by its values; a point array of 8-bit integers is the set of its non-zero vertices.
FileMesh read_vtu(Sources& sources, unsigned file, const Ignored& ignored);

}  // namespace ritz::readers
