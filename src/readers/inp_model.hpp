// The contents of an .inp file before names and numbers are looked up, because keywords may come in any order.
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ritz/readers/inp_deck.hpp"
#include "ritz/readers/listed.hpp"

namespace ritz::readers {

/// What the numbers and names of the lines that are read belong to: an instance of a part, or the model itself.
struct InpScope {
  std::string name = {};  ///< of the instance; empty for the model
  Index nodes = 0;        ///< what is added to the numbers of nodes, so that those of all instances differ
  Index elements = 0;     ///< the same for elements
  std::array<double, 3> translation = {};
  std::array<double, 3> origin = {};  ///< a point of the axis of rotation
  std::array<double, 3> axis = {};    ///< a unit vector
  double cosine = 1, sine = 0;        ///< of the angle
};

/// A *PART: its lines are read again for each of its instances.
struct InpPartLines {
  Deck lines;
  Place place;
};

/// One number (step 0; it must exist) or a range of numbers (those that exist).
struct InpMember {
  Index first;
  Index last;
  Index step;
  Place place;
  Index added = 0;  ///< by the scope, to the numbers as they are written
};

/// A set as it was when another set included it: the lengths of its lists at that time.
struct InpPart {
  std::size_t set;  ///< position in InpSets::sets
  std::size_t positions;
  std::size_t members;
  std::size_t parts;
  std::size_t element_sets;
};

/// A set. Its lists only grow, so that an InpPart stays valid.
struct InpSet {
  std::string name;                       ///< as first written
  std::vector<Index> positions;           ///< listed by NSET= of *NODE or ELSET= of *ELEMENT
  std::vector<InpMember> members;         ///< listed by *NSET or *ELSET
  std::vector<InpPart> parts;             ///< sets named in *NSET or *ELSET
  std::vector<std::size_t> element_sets;  ///< a node set's ELSET=: positions in InpModel::element_sets
};

/// Sets of nodes or of elements, found by name in capitals.
struct InpSets {
  std::vector<InpSet> sets;
  std::map<std::string, std::size_t> index;

  const InpSet* find(const std::string& name) const;
  /// The position of that set, which is created if necessary.
  std::size_t made(const std::string& name);
};

/// The set as it is now.
InpPart whole(const InpSets& sets, std::size_t set);

/// A line of *SURFACE: a set or a number, and a face label, which may be empty.
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

/// What a material contains that ritz does not read ("*HYPERELASTIC is not read"), and where; empty otherwise.
struct InpUnread {
  std::string what;
  Place place;
};

struct InpMaterial {
  std::optional<double> young = {};
  std::optional<double> poisson = {};
  std::optional<double> density = {};
  std::optional<fem::AnyLaw> known_law = {};  ///< of *HYPERELASTIC, or of *ELASTIC that is orthotropic
  InpUnread law = {};
  InpUnread unread_density = {};
};

/// *ORIENTATION: two axes, as OrthotropicStVK has them, in the coordinates of the model.
struct InpOrientation {
  std::array<double, 6> axes = {};
  InpUnread unread = {};
};

struct InpSection {
  std::string element_set;
  std::string material;
  std::string orientation;  ///< its full name; empty if the section has none
  Place place;
};

/// A section, or a transformed coordinate system, that changes the physics if its set is not empty.
struct InpStructure {
  std::string word;  ///< the word for -ignore
  std::string what;
  std::string set;
  Place place;
};

enum class InpMotion { none, prescribed };

struct InpBoundary {
  std::string target;  ///< a node set, a node, or an element set, which stands for its nodes
  std::array<bool, 3> components;
  InpMotion motion;  ///< prescribed: a displacement other than zero
  Place place;
};

/// A data line of *CLOAD, *DLOAD or *DSLOAD.
struct InpLoad {
  std::size_t keyword;  ///< position in InpModel::load_keywords
  std::string target;   ///< a set, a number or a surface; empty: the whole model
  std::vector<Line> fields = {};
  std::string faces = {};  ///< of *DLOAD, P1 ... P6: the surface that was made of the faces it presses
  bool joined = false;     ///< an earlier line has that surface, and the same magnitude
  std::string unfit = {};  ///< why there is no such surface
};

/// A keyword whose data lines are read when they are needed: *AMPLITUDE, *STATIC, *DYNAMIC.
struct InpLines {
  Keyword keyword;
  std::vector<Line> lines = {};
};

/// The model data (the first entry, before any *STEP), or a step.
struct InpStep {
  Place place = {};
  std::optional<Keyword> keyword = {};  ///< *STEP
  std::optional<InpLines> procedure = {};
  std::vector<InpLoad> loads = {};
  std::uint64_t supports = 0;       ///< the same for the same supports in effect
  std::optional<Place> fixed = {};  ///< *BOUNDARY, FIXED: nodes are held where the steps before left them
  std::optional<Place> moved = {};  ///< a displacement other than zero is in effect
  std::vector<InpBoundary> boundaries = {};
  bool own_supports = false;            ///< it has a *BOUNDARY
  bool replaces_supports = false;       ///< its first *BOUNDARY has OP=NEW
  std::optional<Place> frequency = {};  ///< *FREQUENCY
  std::optional<Place> preloaded = {};  ///< PERTURBATION: it starts from the stress of the earlier steps
  std::optional<Place> nonlinear = {};  ///< NLGEOM
  bool loaded = false;                  ///< it has a load
  bool spinning = false;                ///< with CENTRIF or another body load that changes the stiffness
};

struct InpModel {
  Ignored ignored;
  ListedMesh mesh;
  InpScope scope;                                  ///< what is being read
  std::map<std::string, InpPartLines> part_lines;  ///< by name in capitals
  std::map<std::string, InpScope> instances;       ///< by name in capitals
  Index last_node = 0, last_element = 0;           ///< the largest numbers so far
  std::size_t characters_again = 0;                ///< of parts, read again for instances
  InpSets node_sets;
  InpSets element_sets;
  std::vector<InpSurface> surfaces;
  std::map<std::string, InpMaterial> materials;        ///< by name in capitals
  std::string material;                                ///< the material that is being defined
  std::map<std::string, InpOrientation> orientations;  ///< by full name in capitals
  std::vector<InpSection> sections;
  std::vector<InpStructure> structures;  ///< sections of shells, beams, membranes
  std::vector<InpStructure> transforms;
  std::vector<InpStep> steps = {{}};
  std::vector<InpBoundary> boundaries;                       ///< those in effect, of different targets
  std::vector<std::pair<Index, std::string>> element_types;  ///< the first cell of each *ELEMENT, and its type
  std::map<std::string, std::size_t> set_index;              ///< kind and name in capitals -> ListedMesh::sets
  std::map<std::string, std::string> spelling;               ///< name of a set in capitals -> as first written
  std::size_t supported_step = 0;                            ///< whose supports are those of the mesh
  std::vector<Keyword> load_keywords;
  std::multimap<std::string, InpLines> amplitudes;  ///< by name in capitals
  std::map<std::string, Place> passed_over;  ///< keywords that change nothing of the mesh, where they stand first
  std::optional<Place> in_motion;            ///< *INITIAL CONDITIONS with velocities or displacements
  std::optional<Place> temperatures;
  bool expands = false;         ///< *EXPANSION: a change of temperature strains the body
  std::set<std::string> words;  ///< words of -ignore that the file used
};

/// The name that a set, surface or the like has in the model when lines of the scope call it `name`: "INSTANCE.NAME" in
/// an instance.
std::string full_name(const InpScope& scope, const std::string& name);

/// A number of nodes or elements in the model, when lines of a scope call it `number`; `added` is the scope's.
Index full_number(const Deck& deck, Place place, Index number, Index added);

/// The scope that the keyword of a set names by INSTANCE=, else the present one.
const InpScope& scope_of(const Deck& deck, const Keyword& keyword, const InpModel& model);

enum class InpKind { node, element };

/// A field that names a set or a number, as the model has it: "12" and "Bolt.12" become the number of the model, "head"
/// becomes "Bolt.head" in the instance Bolt.
std::string full_target(const Deck& deck, const Line& field, InpKind kind, const InpModel& model);

/// The whole number that `text` is, if it is one.
std::optional<Index> whole_number(std::string_view text);

/// A point of a part where its instance has it: translated, then rotated.
std::array<double, 3> placed(const InpScope& scope, const std::array<double, 3>& point);

/// The *MATERIAL that is being defined; fails if there is none.
InpMaterial& current_material(const Deck& deck, const Keyword& keyword, InpModel& model);

/// One function for each keyword; it reads the data lines of the keyword into the model.
void read_inp_part(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_assembly(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_instance(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_node(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_element(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_nset(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_elset(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_surface(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_material(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_hyperelastic(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_orientation(Deck& deck, const Keyword& keyword, InpModel& model);
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
void read_inp_procedure(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_amplitude(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_load(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_temperature(Deck& deck, const Keyword& keyword, InpModel& model);
void read_inp_initial_conditions(Deck& deck, const Keyword& keyword, InpModel& model);

using InpHandler = void (*)(Deck&, const Keyword&, InpModel&);
/// The function for a keyword of that name: the keyword is obeyed, skipped because it changes nothing that ritz
/// computes, noted, or refused unless the user asks to ignore it.
InpHandler inp_handler(const std::string& name);

/// Reads keywords up to the one that is called `end`, or to the end of the file if that is empty.
void read_keywords(Deck& deck, const std::string& end, Place begin, InpModel& model);

/// The value of a required parameter.
std::string needed(const Deck& deck, const Keyword& keyword, std::string_view parameter);

/// Handles what ritz does not support as readers::leave_out does, once for each word. `words` are names for the same
/// thing; the error suggests the first of them.
void leave_out(const Sources& sources, Place place, const std::vector<std::string>& words, const std::string& what,
               InpModel& model);

/// The element type of a cell, as in its *ELEMENT.
const std::string& element_type(const InpModel& model, Index cell);

/// Adds a note that says how the nodes and elements of several instances are numbered.
void note_instances(InpModel& model);

/// Puts the supports that apply into `boundaries`: those of the first frequency step, or else of the last step. Adds a
/// note if others differ. Throws InputError when the frequency step starts from a stress.
void choose_supports(const Sources& sources, InpModel& model);

/// The set of the mesh with that name and kind, which is created if necessary. Names do not mind capitals: all kinds
/// are spelled as the first.
ListedSet& listed_set(InpModel& model, const std::string& name, std::string_view kind);

/// Reads the whole deck and looks up every name and number: what is left is to finish the mesh. Throws InputError.
InpModel read_inp_model(Sources& sources, unsigned file, const Ignored& ignored);

/// Looks up every name and number. Throws InputError.
void resolve_inp(const Sources& sources, InpModel& model);

/// Adds a note for every word of -ignore that left nothing out.
void note_idle_words(InpModel& model);

/// A few lines of a file can list the same numbers very often (ranges, sets of sets). Therefore the total of what all
/// sets list is limited, generously, by the size of the file.
class InpBudget {
 public:
  explicit InpBudget(const Sources& sources);
  /// Counts `entries` of a set. Throws an InputError that names the set when the total exceeds the limit.
  void spend(const Sources& sources, const std::string& set, std::uint64_t entries);

 private:
  std::uint64_t allowed_;
  std::uint64_t spent_ = 0;
};

/// Makes a surface of the faces that *DLOAD presses, so that a scene can name them: "SET.P2" of the faces P2 of an
/// element set; "DLOAD-3" of the elements that the third *DLOAD lists by number, "DLOAD-3.2" and so on where it has
/// several magnitudes. An apostrophe is added to a name that another surface has.
void press_faces(const Sources& sources, InpBudget& budget, InpModel& model);

/// Numbers that sets list but that the file does not define.
struct InpMissing {
  std::string first;                                      ///< a sentence about the first one
  std::set<std::pair<std::uint64_t, std::uint64_t>> all;  ///< file and offset of each
};

/// The contents of a set: positions, ascending, and the element sets whose nodes it contains.
struct InpContent {
  std::vector<Index> positions;
  std::set<std::size_t> element_sets;
  bool by_number = false;  ///< some entries come from *NSET or *ELSET, not all from the keywords that define them
};

/// The contents of a set. `what` is "node" or "element". Throws InputError.
InpContent content(const Sources& sources, const InpSets& sets, std::size_t set, const IdMap& ids,
                   const std::string& what, InpBudget& budget, InpMissing& missing);

/// Sorts the values and removes duplicates.
void keep_unique(std::vector<Index>& values);

/// How ritz treats an element type: as its own element; as its own element instead of another formulation (with a note,
/// or only if the user asks for it); or not at all.
enum class InpReading { same, noted, on_your_word, none };

struct InpType {
  InpReading reading;
  Shape shape;        ///< except for `none`
  std::string plain;  ///< the type as which it is read: "C3D8"
  std::string formulation;
  std::string_view points;  ///< for `on_your_word`: the integration points of `plain`, and what difference they make
};

/// The treatment of an element type, whose `name` is in capitals. Elements of lower dimension only form sets.
InpType inp_type(const std::string& name);

/// The words for which -ignore leaves out the elements of an unsupported type: the keyword that gives them their
/// properties ("SPRING" for SPRINGA), if there is one, and the type.
std::vector<std::string> words_of_type(const std::string& name);

}  // namespace ritz::readers
