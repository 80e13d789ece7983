// What an .inp file says, before names and numbers are looked up: an order of keywords is not prescribed.
#pragma once
#include <map>

#include "ritz/mesh/read_inp_deck.hpp"
#include "ritz/mesh/read_listed.hpp"

namespace ritz::mesh {

/// One number (step 0, must exist) or a range of them (those that exist).
struct InpMember {
  Index first;
  Index last;
  Index step;
  Place place;
};

struct InpSet {
  std::string name;                       ///< as first written
  std::vector<Index> positions;           ///< listed by NSET= of *NODE or ELSET= of *ELEMENT
  std::vector<InpMember> members;         ///< listed by *NSET or *ELSET
  std::vector<std::size_t> element_sets;  ///< a node set's ELSET=: positions in InpModel::element_sets
};

/// Sets of nodes or of elements, found by their names in capitals.
struct InpSets {
  std::vector<InpSet> sets;
  std::map<std::string, std::size_t> index;

  const InpSet* find(const std::string& name) const;
  /// The position of that set, made if need be.
  std::size_t made(const std::string& name);
};

/// A line of *SURFACE: a set or a number, and a face label (may be empty).
struct InpSurfaceEntry {
  std::string target;
  std::string label;
  Place place;
};

enum class InpSurfaceType { element, node };

struct InpSurface {
  std::string name;
  InpSurfaceType type;
  std::vector<InpSurfaceEntry> entries;
};

struct InpMaterial {
  std::optional<double> young;
  std::optional<double> poisson;
  std::optional<double> density;
  Place place = {};
};

struct InpSection {
  std::string element_set;
  std::string material;
  Place place;
};

struct InpBoundary {
  std::string target;  ///< a node set, a node, or an element set: its elements' nodes
  std::array<bool, 3> components;
  Place place;
};

struct InpModel {
  ListedMesh mesh;
  InpSets node_sets;
  InpSets element_sets;
  std::vector<InpSurface> surfaces;
  std::map<std::string, InpMaterial> materials;  ///< by name in capitals
  std::string material;                          ///< the one being defined
  std::vector<InpSection> sections;
  std::vector<InpBoundary> boundaries;
};

/// One function a keyword: reads its data lines into the model.
void read_inp_node(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_element(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_nset(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_elset(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_surface(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_material(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_elastic(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_density(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_section(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_boundary(Deck& deck, const Keyword& keyword, InpModel& model);

/// The value of a parameter that must be there.
std::string needed(const Deck& deck, const Keyword& keyword, std::string_view parameter);

/// Looks up every name and number, and checks the mesh. Throws InputError.
FileMesh resolve_inp(const Sources& sources, InpModel model);

}  // namespace ritz::mesh
