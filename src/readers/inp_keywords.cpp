// The keywords of Abaqus and CalculiX: those that ritz obeys, those that change nothing of what it computes (the
// vibration of the unloaded body, its small and large motions under the loads of a scene), and those that do.
#include "ritz/readers/inp_model.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace ritz::readers {

namespace {

struct Obeyed {
  std::string_view name;
  InpHandler handler;
};

constexpr Obeyed obeyed[] = {{"PART", read_inp_part},
                             {"ASSEMBLY", read_inp_assembly},
                             {"INSTANCE", read_inp_instance},
                             {"NODE", read_inp_node},
                             {"ELEMENT", read_inp_element},
                             {"NSET", read_inp_nset},
                             {"ELSET", read_inp_elset},
                             {"SURFACE", read_inp_surface},
                             {"MATERIAL", read_inp_material},
                             {"ELASTIC", read_inp_elastic},
                             {"DENSITY", read_inp_density},
                             {"EXPANSION", read_inp_expansion},
                             {"SOLIDSECTION", read_inp_section},
                             {"BOUNDARY", read_inp_boundary},
                             {"STEP", read_inp_step},
                             {"FREQUENCY", read_inp_frequency},
                             {"STATIC", read_inp_procedure},
                             {"DYNAMIC", read_inp_procedure},
                             {"MODALDYNAMIC", read_inp_procedure},
                             {"VISCO", read_inp_procedure},
                             {"BUCKLE", read_inp_procedure},
                             {"STEADYSTATEDYNAMICS", read_inp_procedure},
                             {"RANDOMRESPONSE", read_inp_procedure},
                             {"RESPONSESPECTRUM", read_inp_procedure},
                             {"DIRECTCYCLIC", read_inp_procedure},
                             {"GREEN", read_inp_procedure},
                             {"AMPLITUDE", read_inp_amplitude},
                             {"CLOAD", read_inp_load},
                             {"DLOAD", read_inp_load},
                             {"DSLOAD", read_inp_load},
                             {"TEMPERATURE", read_inp_temperature},
                             {"INITIALCONDITIONS", read_inp_initial_conditions},
                             {"TRANSFORM", read_inp_transform},
                             {"SHELLSECTION", read_inp_structure},
                             {"SHELLGENERALSECTION", read_inp_structure},
                             {"BEAMSECTION", read_inp_structure},
                             {"BEAMGENERALSECTION", read_inp_structure},
                             {"FRAMESECTION", read_inp_structure},
                             {"MEMBRANESECTION", read_inp_structure},
                             {"SURFACESECTION", read_inp_structure},
                             {"HYPERELASTIC", read_inp_hyperelastic},
                             {"ORIENTATION", read_inp_orientation},
                             {"HYPERFOAM", read_inp_other_law},
                             {"ANISOTROPICHYPERELASTIC", read_inp_other_law},
                             {"HYPOELASTIC", read_inp_other_law},
                             {"POROUSELASTIC", read_inp_other_law},
                             {"LOWDENSITYFOAM", read_inp_other_law},
                             {"FABRIC", read_inp_other_law},
                             {"USERMATERIAL", read_inp_other_law},
                             {"DEFORMATIONPLASTICITY", read_inp_other_law}};

// Output, settings of procedures, loads that no mesh and no scene has, definitions that nothing read uses.
constexpr std::string_view harmless =
    "HEADING PREPRINT ENDSTEP NODEPRINT NODEFILE NODEOUTPUT ELPRINT ELFILE ELEMENTOUTPUT ELEMENTMATRIXOUTPUT "
    "ENERGYPRINT ENERGYFILE ENERGYOUTPUT CONTACTPRINT CONTACTFILE CONTACTOUTPUT SECTIONPRINT SECTIONFILE "
    "SURFACEOUTPUT MODALPRINT MODALFILE MODALOUTPUT INCREMENTATIONOUTPUT INTEGRATEDOUTPUT INTEGRATEDOUTPUTSECTION "
    "OUTPUT HISTORYOUTPUT FIELDOUTPUT FILEFORMAT FILEOUTPUT POSTOUTPUT PRINT MONITOR DIAGNOSTICS RESTART "
    "USEROUTPUTVARIABLES DISPLAYBODY TIMEPOINTS CONTROLS SOLVERCONTROLS SECTIONCONTROLS HOURGLASSSTIFFNESS "
    "BULKVISCOSITY SUBSTRUCTUREGENERATE RETAINEDNODALDOFS SELECTEIGENMODES SENSITIVITY DESIGNVARIABLES DESIGNRESPONSE "
    "OBJECTIVE "
    "CONSTRAINT FILTER GEOMETRICCONSTRAINT GEOMETRICTOLERANCE ROBUSTDESIGN CORRELATIONLENGTH DAMPING MODALDAMPING "
    "GLOBALDAMPING BASEMOTION CFLUX DFLUX DSFLUX FILM SFILM RADIATE SRADIATE FIELD SPECTRUM PSD-DEFINITION "
    "CORRELATION DISTRIBUTION DISTRIBUTIONTABLE NORMAL NODALTHICKNESS SURFACEINTERACTION SURFACEBEHAVIOR "
    "FRICTION CHANGEFRICTION CHANGESURFACEBEHAVIOR CONTACTDAMPING GAPCONDUCTANCE GAPHEATGENERATION GAPRADIATION "
    "PHYSICALCONSTANTS VALUESATINFINITY VIEWFACTOR CONDUCTIVITY SPECIFICHEAT LATENTHEAT INELASTICHEATFRACTION "
    "ELECTRICALCONDUCTIVITY JOULEHEATFRACTION MAGNETICPERMEABILITY FLUIDCONSTANTS SPECIFICGASCONSTANT DEPVAR "
    "NOANALYSIS SOLUTIONTECHNIQUE RADIATIONPRINT RADIATIONFILE RADIATIONOUTPUT SUBSTRUCTUREPATH "
    "SUBSTRUCTUREMATRIXOUTPUT SUBSTRUCTUREOUTPUT MATRIXGENERATE MATRIXOUTPUT NODERESPONSE ELEMENTRESPONSE "
    "DESIGNPARAMETER FEASIBLEDIRECTION RANDOMFIELD HCF MASSFLOW SURFACEPROPERTY SURFACESMOOTHING "
    "CAVITYDEFINITION EMISSIVITY FAILSTRESS FAILSTRAIN UNIAXIALTESTDATA BIAXIALTESTDATA PLANARTESTDATA "
    "SIMPLESHEARTESTDATA VOLUMETRICTESTDATA SHEARTESTDATA COMBINEDTESTDATA TRS COHESIVEBEHAVIOR SOLUBILITY "
    "DIFFUSIVITY PERMEABILITY DIELECTRIC";

// What a solid does beyond its elastic law: nothing at rest, much in a large motion.
constexpr std::string_view inelastic =
    "PLASTIC CHANGEPLASTIC CYCLICHARDENING CREEP RATEDEPENDENT POTENTIAL SWELLING MULLINSEFFECT DRUCKERPRAGER "
    "DRUCKERPRAGERHARDENING MOHRCOULOMB CAPPLASTICITY MOHRCOULOMBHARDENING CAPHARDENING CONCRETEDAMAGEDPLASTICITY "
    "CRUSHABLEFOAM CASTIRON CRUSHABLEFOAMHARDENING TENSILEFAILURE POROUSMETALPLASTICITY SHEARFAILURE DAMAGEINITIATION "
    "DAMAGEEVOLUTION SUPERELASTIC SUPERELASTICHARDENING CONCRETE CONCRETECOMPRESSIONHARDENING "
    "CONCRETETENSIONSTIFFENING CONCRETECOMPRESSIONDAMAGE CONCRETETENSIONDAMAGE CONCRETEFAILURE FAILURERATIOS "
    "SHEARRETENTION BRITTLECRACKING BRITTLEFAILURE BRITTLESHEAR TENSIONCUTOFF CLAYPLASTICITY CLAYHARDENING CAPCREEP "
    "DRUCKERPRAGERCREEP CASTIRONCOMPRESSIONHARDENING CASTIRONTENSIONHARDENING CYCLEDPLASTIC ORNL "
    "POROUSFAILURECRITERIA VOIDNUCLEATION VISCOUS ANNEALTEMPERATURE MOISTURESWELLING CREEPSTRAINRATECONTROL "
    "DAMAGESTABILIZATION";

struct Refused {
  std::string_view name;
  std::string_view does;
  std::string_view led_by = {};  // the keyword that this one belongs to, and that -ignore names
};

constexpr Refused refused[] = {{"EQUATION", "ties degrees of freedom together"},
                               {"MPC", "ties nodes together"},
                               {"NETWORKMPC", "ties nodes together"},
                               {"TIE", "ties surfaces together"},
                               {"RIGIDBODY", "makes a part of the model rigid"},
                               {"COUPLING", "couples a surface to a node"},
                               {"KINEMATIC", "couples a surface to a node", "COUPLING"},
                               {"DISTRIBUTING", "couples a surface to a node", "COUPLING"},
                               {"KINEMATICCOUPLING", "couples nodes to a node"},
                               {"DISTRIBUTINGCOUPLING", "couples nodes to a node"},
                               {"SHELLTOSOLIDCOUPLING", "couples a shell to a solid"},
                               {"EMBEDDEDELEMENT", "ties elements to those around them"},
                               {"FASTENER", "ties surfaces together"},
                               {"SPRING", "adds stiffness"},
                               {"DASHPOT", "adds damping"},
                               {"MASS", "adds mass"},
                               {"ROTARYINERTIA", "adds inertia"},
                               {"NONSTRUCTURALMASS", "adds mass"},
                               {"FIXEDMASSSCALING", "changes the mass"},
                               {"VARIABLEMASSSCALING", "changes the mass"},
                               {"FOUNDATION", "rests faces on springs"},
                               {"GAP", "lets nodes touch"},
                               {"JOINT", "joins nodes"},
                               {"CONNECTORSECTION", "joins nodes"},
                               {"CONNECTORBEHAVIOR", "joins nodes", "CONNECTORSECTION"},
                               {"CONNECTORELASTICITY", "joins nodes", "CONNECTORSECTION"},
                               {"CONNECTORDAMPING", "joins nodes", "CONNECTORSECTION"},
                               {"CONNECTORFRICTION", "joins nodes", "CONNECTORSECTION"},
                               {"CONNECTORPLASTICITY", "joins nodes", "CONNECTORSECTION"},
                               {"CONNECTORHARDENING", "joins nodes", "CONNECTORSECTION"},
                               {"CONNECTORSTOP", "joins nodes", "CONNECTORSECTION"},
                               {"CONNECTORLOCK", "joins nodes", "CONNECTORSECTION"},
                               {"CONNECTORCONSTITUTIVEREFERENCE", "joins nodes", "CONNECTORSECTION"},
                               {"CONNECTORMOTION", "joins nodes", "CONNECTORSECTION"},
                               {"CONNECTORLOAD", "joins nodes", "CONNECTORSECTION"},
                               {"CONTACTPAIR", "lets surfaces touch"},
                               {"CLEARANCE", "lets surfaces touch", "CONTACTPAIR"},
                               {"CONTACT", "lets surfaces touch"},
                               {"CONTACTINCLUSIONS", "lets surfaces touch", "CONTACT"},
                               {"CONTACTEXCLUSIONS", "lets surfaces touch", "CONTACT"},
                               {"CONTACTPROPERTYASSIGNMENT", "lets surfaces touch", "CONTACT"},
                               {"CONTACTINITIALIZATIONDATA", "lets surfaces touch", "CONTACT"},
                               {"CONTACTINITIALIZATIONASSIGNMENT", "lets surfaces touch", "CONTACT"},
                               {"SURFACEPROPERTYASSIGNMENT", "lets surfaces touch", "CONTACT"},
                               {"CONTACTCLEARANCE", "lets surfaces touch", "CONTACT"},
                               {"CONTACTCLEARANCEASSIGNMENT", "lets surfaces touch", "CONTACT"},
                               {"CONTACTCONTROLSASSIGNMENT", "lets surfaces touch", "CONTACT"},
                               {"CONTACTFORMULATION", "lets surfaces touch", "CONTACT"},
                               {"CONTACTSTABILIZATION", "lets surfaces touch", "CONTACT"},
                               {"CONTACTINTERFERENCE", "lets surfaces touch", "CONTACTPAIR"},
                               {"CONTACTCONTROLS", "lets surfaces touch", "CONTACTPAIR"},
                               {"MODELCHANGE", "takes parts of the model out or back in"},
                               {"CHANGEMATERIAL", "changes a material between steps"},
                               {"CHANGESOLIDSECTION", "changes a section between steps"},
                               {"PRE-TENSIONSECTION", "stresses a bolt"},
                               {"CYCLICSYMMETRYMODEL", "makes the mesh one sector of a cycle"},
                               {"SELECTCYCLICSYMMETRYMODES", "asks for modes of a cycle", "CYCLICSYMMETRYMODEL"},
                               {"SUBMODEL", "drives a boundary by another model"},
                               {"USERELEMENT", "defines an element of the user"},
                               {"USERSECTION", "gives elements of the user their stiffness"},
                               {"MATRIXINPUT", "adds a matrix"},
                               {"MATRIXASSEMBLE", "adds a matrix"},
                               {"SUPERELEMENT", "adds a reduced part"},
                               {"REBAR", "adds stiffness"},
                               {"REBARLAYER", "adds stiffness"},
                               {"COHESIVESECTION", "gives elements stiffness"},
                               {"GASKETSECTION", "gives elements stiffness"},
                               {"FLUIDSECTION", "defines a fluid"},
                               {"ACOUSTICMEDIUM", "defines a fluid"},
                               {"ADAPTIVEMESH", "moves the nodes"},
                               {"LOADCASE", "gives a step several sets of supports and loads"},
                               {"ENDLOADCASE", "gives a step several sets of supports and loads", "LOADCASE"},
                               {"SUBSTRUCTUREPROPERTY", "adds a reduced part"},
                               {"PIEZOELECTRIC", "couples strains to an electric field"},
                               {"NOCOMPRESSION", "takes the stiffness in compression away"},
                               {"NOTENSION", "takes the stiffness in tension away"},
                               {"VISCOELASTIC", "makes the stiffness depend on the frequency"},
                               {"INERTIARELIEF", "changes the supports"},
                               {"IMPERFECTION", "moves the nodes"},
                               {"INITIALSTRAININCREASE", "strains the body"},
                               {"GEOSTATIC", "stresses the body"},
                               {"COMPLEXFREQUENCY", "asks for complex modes"},
                               {"HEATTRANSFER", "asks for temperatures"},
                               {"COUPLEDTEMPERATURE-DISPLACEMENT", "asks for temperatures"},
                               {"UNCOUPLEDTEMPERATURE-DISPLACEMENT", "asks for temperatures"},
                               {"ELECTROMAGNETICS", "asks for electromagnetic fields"},
                               {"CFD", "asks for a flow"},
                               {"SOILS", "asks for pore pressures"},
                               {"CRACKPROPAGATION", "asks for the growth of a crack"},
                               {"REFINEMESH", "makes another mesh"},
                               {"SYSTEM", "gives the coordinates of the nodes in another system"},
                               {"NGEN", "generates nodes"},
                               {"NFILL", "generates nodes"},
                               {"NCOPY", "generates nodes"},
                               {"NMAP", "moves nodes"},
                               {"ELGEN", "generates elements"},
                               {"ELCOPY", "generates elements"},
                               {"PARAMETER", "puts values in the place of names"}};

void pass_over(Deck&, const Keyword& keyword, InpModel& model) {
  model.passed_over.try_emplace(keyword.name, keyword.place);
}

// Once a keyword of that name: a plastic law a material would be a note a material.
void note_inelastic(Deck& deck, const Keyword& keyword, InpModel& model) {
  if (model.words.insert(keyword.name).second)
    model.mesh.notes.push_back(located(deck.sources(), keyword.place) + "*" + keyword.title +
                               " is passed over: the materials of ritz stay elastic, however large the strains");
}

// Those that are met where they belong never come here.
void refuse_end(Deck& deck, const Keyword& keyword, InpModel&) {
  deck.fail(keyword.place, "*" + keyword.title + " ends nothing that has begun");
}

void refuse(Deck& deck, const Keyword& keyword, InpModel& model) {
  const auto known =
      std::find_if(std::begin(refused), std::end(refused), [&](auto& r) { return r.name == keyword.name; });
  const auto word = known->led_by.empty() ? known->name : known->led_by;
  leave_out(deck.sources(), keyword.place, {std::string(word), keyword.name},
            "*" + keyword.title + " " + std::string(known->does) + ", which ritz cannot do", model);
}

// A file named by *INCLUDE may be any file: what stands in it is not shown.
void refuse_unknown(Deck& deck, const Keyword& keyword, InpModel& model) {
  if (keyword.name.empty()) deck.fail(keyword.place, "a star without a keyword; a comment begins with two stars");
  const bool left_out = std::find(model.ignored.begin(), model.ignored.end(), keyword.name) != model.ignored.end();
  if (keyword.place.file > 0 && !left_out)
    deck.fail(keyword.place,
              "ritz does not know the keyword of this line, which may change the physics; -ignore with "
              "its name leaves it out, and the result is then of another model");
  leave_out(deck.sources(), keyword.place, {keyword.name},
            "ritz does not know the keyword *" + keyword.title + ", which may change the physics", model);
}

std::vector<std::string> words_of(std::string_view list) {
  std::istringstream words{std::string(list)};
  return {std::istream_iterator<std::string>(words), {}};
}

std::map<std::string, InpHandler, std::less<>> all_handlers() {
  std::map<std::string, InpHandler, std::less<>> table;
  for (const auto& [name, handler] : obeyed) table.emplace(name, handler);
  for (auto& name : words_of(harmless)) table.emplace(std::move(name), pass_over);
  for (auto& name : words_of(inelastic)) table.emplace(std::move(name), note_inelastic);
  for (const auto& keyword : refused) table.emplace(keyword.name, refuse);
  for (const char* const name : {"ENDPART", "ENDINSTANCE", "ENDASSEMBLY"}) table.emplace(name, refuse_end);
  return table;
}

}  // namespace

InpHandler inp_handler(const std::string& name) {
  static const auto table = all_handlers();
  const auto found = table.find(name);
  return found != table.end() ? found->second : refuse_unknown;
}

}  // namespace ritz::readers
