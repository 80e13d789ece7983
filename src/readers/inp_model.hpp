// What an .inp file says, before names and numbers are looked up: an order of keywords is not prescribed.
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ritz/readers/inp_deck.hpp"
#include "ritz/readers/listed.hpp"

namespace ritz::readers {

/// One number (step 0, must exist) or a range of them (those that exist).
struct InpMember {
  Index first;
  Index last;
  Index step;
  Place place;
};

/// A set as it stood when another one took it in: the first so many of each of its lists.
struct InpPart {
  std::size_t set;  ///< position in InpSets::sets
  std::size_t positions;
  std::size_t members;
  std::size_t parts;
  std::size_t element_sets;
};

/// The lists only grow, so that an InpPart keeps its meaning.
struct InpSet {
  std::string name;                       ///< as first written
  std::vector<Index> positions;           ///< listed by NSET= of *NODE or ELSET= of *ELEMENT
  std::vector<InpMember> members;         ///< listed by *NSET or *ELSET
  std::vector<InpPart> parts;             ///< sets named in *NSET or *ELSET
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

InpPart whole(const InpSets& sets, std::size_t set);

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

/// What a material states that ritz does not read ("*HYPERELASTIC is not read"), and where; empty otherwise.
struct InpUnread {
  std::string what;
  Place place;
};

struct InpMaterial {
  std::optional<double> young;
  std::optional<double> poisson;
  std::optional<double> density;
  InpUnread law = {};
  InpUnread unread_density = {};
};

struct InpSection {
  std::string element_set;
  std::string material;
  Place place;
};

/// A section, or a transformed coordinate system, that changes the physics where its set holds anything.
struct InpStructure {
  std::string word;  ///< for -ignore
  std::string what;
  std::string set;
  Place place;
};

enum class InpMotion { none, prescribed };

struct InpBoundary {
  std::string target;  ///< a node set, a node, or an element set: its elements' nodes
  std::array<bool, 3> components;
  InpMotion motion;  ///< prescribed: a displacement other than zero
  Place place;
};

/// The model data (the first one, before any *STEP), or a step.
struct InpStep {
  Place place = {};
  std::vector<InpBoundary> boundaries = {};
  bool own_supports = false;            ///< a *BOUNDARY stands in it
  bool replaces_supports = false;       ///< whose first says OP=NEW
  std::optional<Place> frequency = {};  ///< *FREQUENCY
  std::optional<Place> preloaded = {};  ///< PERTURBATION: it starts from the stress of the steps before
  std::optional<Place> nonlinear = {};  ///< NLGEOM
  bool loaded = false;                  ///< a load stands in it
  bool spinning = false;                ///< with CENTRIF or another body load, which changes the stiffness
};

struct InpModel {
  Ignored ignored;
  ListedMesh mesh;
  InpSets node_sets;
  InpSets element_sets;
  std::vector<InpSurface> surfaces;
  std::map<std::string, InpMaterial> materials;  ///< by name in capitals
  std::string material;                          ///< the one being defined
  std::vector<InpSection> sections;
  std::vector<InpStructure> structures;  ///< sections of shells, beams, membranes
  std::vector<InpStructure> transforms;
  std::vector<InpStep> steps = {{}};
  std::vector<InpBoundary> boundaries;                       ///< those in effect, of different targets
  std::vector<std::pair<Index, std::string>> element_types;  ///< the first cell of each *ELEMENT, and its type
  std::optional<Place> temperatures;
  bool expands = false;         ///< *EXPANSION: a change of temperature strains the body
  std::set<std::string> words;  ///< of -ignore, that the file had a use for
};

/// One function a keyword: reads its data lines into the model.
void read_inp_node(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_element(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_nset(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_elset(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_surface(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_material(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_elastic(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_other_law(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_density(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_expansion(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_section(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_structure(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_transform(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_boundary(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_step(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_frequency(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_load(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_temperature(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_initial_conditions(Deck& deck, const Keyword& keyword, InpModel& model);

using InpHandler = void (*)(Deck&, const Keyword&, InpModel&);
/// What is done about a keyword of that name: it is obeyed, passed over because it changes nothing that ritz computes,
/// noted, or refused unless the user leaves it out.
InpHandler inp_handler(const std::string& name);

/// The value of a parameter that must be there.
std::string needed(const Deck& deck, const Keyword& keyword, std::string_view parameter);

/// Leaves out what `what` says, once a word, as leave_out does; `words` are names for the same thing, the first of them
/// the one that the error proposes.
void leave_out(const Sources& sources, Place place, const std::vector<std::string>& words, const std::string& what,
               InpModel& model);

/// The type of a cell as its *ELEMENT says it.
const std::string& element_type(const InpModel& model, Index cell);

/// Puts the supports that count into `boundaries`: those of the first frequency step, else of the last step. Adds a
/// note where others differ. Throws InputError where the frequency step starts from a stress.
void choose_supports(const Sources& sources, InpModel& model);

/// Looks up every name and number, and checks the mesh. Throws InputError.
FileMesh resolve_inp(const Sources& sources, InpModel model);

/// A file of few lines can list the same numbers without end (ranges, sets of sets). What all its sets list in all is
/// bounded by the file's size, generously.
class InpBudget {
 public:
  explicit InpBudget(const Sources& sources);
  /// Throws InputError, which names the set, when all sets so far list more than the file's size warrants.
  void spend(const Sources& sources, const std::string& set, std::uint64_t entries);

 private:
  std::uint64_t allowed_;
  std::uint64_t spent_ = 0;
};

/// Numbers that sets list and that the file does not have.
struct InpMissing {
  std::string first;                                      ///< a sentence on the first one
  std::set<std::pair<std::uint64_t, std::uint64_t>> all;  ///< file and offset of each
};

/// The positions, ascending, of what a set lists, and the element sets whose nodes it takes.
struct InpContent {
  std::vector<Index> positions;
  std::set<std::size_t> element_sets;
  bool by_number = false;  ///< some are listed by *NSET or *ELSET, not all by the keywords that define them
};

/// `what` is "node" or "element". Throws InputError.
InpContent content(const Sources& sources, const InpSets& sets, std::size_t set, const IdMap& ids,
                   const std::string& what, InpBudget& budget, InpMissing& missing);

/// Each value once, ascending.
void keep_unique(std::vector<Index>& values);

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

}  // namespace ritz::readers
