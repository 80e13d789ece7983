// Keywords that ritz obeys, that change nothing, and that change the physics: the last end with a sentence, or are left
// out on the user's word with a note.
#include <gtest/gtest.h>

#include "readers/fixture.hpp"
#include "ritz/base/error.hpp"

namespace ritz::readers::testing {
namespace {

std::size_t notes_that_say(const FileMesh& mesh, const std::string& text) {
  std::size_t count = 0;
  for (const auto& note : mesh.notes) count += note.find(text) != std::string::npos;
  return count;
}

struct Physics {
  const char* word;   ///< of -ignore
  const char* title;  ///< as the error says it
  const char* text;
};

const Physics physics[] = {
    {"EQUATION", "*EQUATION", "*EQUATION\n2\n10,1,1.,7,1,-1.\n"},
    {"MPC", "*MPC", "*MPC\nBEAM, 10, 7\n"},
    {"TIE", "*TIE", "*Tie, NAME=t\na, b\n"},
    {"RIGIDBODY", "*RIGID BODY", "*Rigid  Body, NSET=feet, REF NODE=50\n"},
    {"COUPLING", "*COUPLING", "*COUPLING, CONSTRAINT NAME=c, REF NODE=50, SURFACE=s\n*KINEMATIC\n1, 3\n"},
    {"COUPLING", "*COUPLING", "*COUPLING, CONSTRAINT NAME=c, REF NODE=50, SURFACE=s\n*DISTRIBUTING\n1, 3\n"},
    {"MODELCHANGE", "*MODEL CHANGE", "*MODEL CHANGE, TYPE=ELEMENT, REMOVE\nupper\n"},
    {"SPRING", "SPRING1", "*ELEMENT, TYPE=SPRING1, ELSET=sp\n99, 10\n*SPRING, ELSET=sp\n3\n1000.\n"},
    {"SPRINGA", "SPRINGA", "*ELEMENT, TYPE=SPRINGA, ELSET=sp\n99, 10, 50\n*SPRING, ELSET=sp\n\n1000.\n"},
    {"MASS", "MASS", "*ELEMENT, TYPE=MASS, ELSET=m\n99, 10\n*MASS, ELSET=m\n1e-4\n"},
    {"DASHPOT", "DASHPOTA", "*ELEMENT, TYPE=DASHPOTA, ELSET=d\n99, 10, 7\n*DASHPOT, ELSET=d\n\n1.\n"},
    {"ROTARYINERTIA", "ROTARYI", "*ELEMENT, TYPE=ROTARYI, ELSET=r\n99, 10\n*ROTARY INERTIA, ELSET=r\n1.,1.,1.\n"},
    {"CONTACTPAIR", "*CONTACT PAIR", "*CONTACT PAIR, INTERACTION=i,\nSMALL SLIDING, TYPE=NODE TO SURFACE\na, b\n"},
    {"FOUNDATION", "*FOUNDATION", "*FOUNDATION\nlower, F1, 1e6\n"},
    {"NOCOMPRESSION", "*NO COMPRESSION", "*NO COMPRESSION\n"},
    {"SHELLSECTION", "*SHELL SECTION", "*SHELL SECTION, ELSET=Bottom, MATERIAL=STEEL\n.1\n"},
    {"MEMBRANESECTION", "*MEMBRANE SECTION", "*MEMBRANE SECTION, ELSET=Bottom,\nMATERIAL=STEEL\n.1\n"},
    {"BEAMSECTION", "*BEAM SECTION",
     "*ELEMENT, TYPE=B31, ELSET=rod\n99, 10, 50\n*BEAM SECTION, ELSET=rod, MATERIAL=STEEL, SECTION=RECT\n.1,.1\n"},
    {"T3D2", "type T3D2",
     "*ELEMENT, TYPE=T3D2, ELSET=rod\n99, 10, 50\n*SOLID SECTION, ELSET=rod, MATERIAL=STEEL\n.1\n"},
    {"CPS3", "type CPS3", "*SOLID SECTION, ELSET=Bottom, MATERIAL=STEEL\n.1\n"},
    {"INITIALCONDITIONS", "*INITIAL CONDITIONS", "*INITIAL CONDITIONS, TYPE=STRESS\nlower, 1., 0., 0., 0., 0., 0.\n"},
    {"TRANSFORM", "*TRANSFORM", "*TRANSFORM, NSET=feet, TYPE=R\n1., 1., 0., -1., 1., 0.\n"},
    {"TEMPERATURE", "*TEMPERATURE", "*EXPANSION\n1e-5\n*TEMPERATURE\nNall, 100.\n"},
    {"HEATTRANSFER", "*HEAT TRANSFER", "*HEAT TRANSFER, STEADY STATE\n"},
    {"SOMETHINGNEW", "*SOMETHING NEW", "*Something new, EXTRA\n1, 2\n"}};

TEST(ReadInpKeywords, ThatChangeThePhysicsAreRefusedByName) {
  for (const auto& [word, title, text] : physics) {
    SCOPED_TRACE(text);
    const auto error = error_of("a.inp", inp_with(text));
    EXPECT_NE(error.find("a.inp:3"), std::string::npos) << error;  // lines 36 to 39
    EXPECT_NE(error.find(title), std::string::npos) << error;
    EXPECT_NE(error.find("-ignore "), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

TEST(ReadInpKeywords, AreLeftOutOnTheUsersWordWithANote) {
  for (const auto& [word, title, text] : physics) {
    SCOPED_TRACE(text);
    const auto mesh = read_text("a.inp", inp_with(text), {word});
    expect_two_tets(mesh, "Lower", "upper", "Bottom");
    EXPECT_EQ(notes_that_say(mesh, title), 1u);
    EXPECT_EQ(notes_that_say(mesh, "(-ignore " + std::string(word) + ")"), 1u);
    EXPECT_EQ(mesh.notes.size(), 1u);
  }
}

TEST(ReadInpKeywords, AreNotedOnceHoweverOftenTheyStand) {
  const std::string one = "*EQUATION\n2\n10,1,1.,7,1,-1.\n*TIE, NAME=t\na, b\n";
  const auto mesh = read_text("a.inp", inp_with(one + one + one), {"TIE", "EQUATION"});
  EXPECT_EQ(mesh.notes.size(), 2u);
  EXPECT_NE(error_of("a.inp", inp_with(one), {"EQUATION"}).find("a.inp:39: *TIE"), std::string::npos);
}

TEST(ReadInpKeywords, ThatWereIgnoredInVainAreTold) {
  const auto mesh = read_text("a.inp", inp_text(), {"TEI"});
  EXPECT_EQ(notes_that_say(mesh, "-ignore TEI left nothing out"), 1u);
}

TEST(ReadInpKeywords, ThatChangeNothingArePassedOver) {
  auto text = inp_with(
      "*PREPRINT, ECHO=NO\n*RESTART, WRITE\n*ORIENTATION, NAME=o\n1.,0.,0.,0.,1.,0.\n*AMPLITUDE, NAME=a\n0.,0.,1.,1.\n"
      "*SURFACE INTERACTION, NAME=i\n*FRICTION\n.3\n*PHYSICAL CONSTANTS, ABSOLUTE ZERO=0.\n*EXPANSION\n1e-5\n"
      "*CONDUCTIVITY\n50.\n*SPECIFIC HEAT\n500.\n*DAMPING, ALPHA=1.\n*INITIAL CONDITIONS, TYPE=TEMPERATURE\n"
      "Nall, 20.\n");
  text = with(text, "*STEP\n",
              "*STEP, INC=10\n*STATIC, DIRECT\n.1, 1.\n*CONTROLS, RESET\n*CLOAD\n10, 1, 1.\n*DLOAD\nlower, P1, 1.\n");
  text =
      with(text, "*END STEP", "*NODE PRINT, NSET=Nall\nU\n*EL FILE\nS\n*OUTPUT, FIELD\n*ELEMENT OUTPUT\nS\n*END STEP");
  const auto mesh = read_text("a.inp", text);
  expect_two_tets(mesh, "Lower", "upper", "Bottom");
  EXPECT_TRUE(mesh.notes.empty()) << mesh.notes.front();
}

TEST(ReadInpKeywords, OfSettingsAndDataThatNothingUsesArePassedOver) {
  for (const char* const text :
       {"*FAIL STRESS\n1., 2., 3., 4., 5.\n", "*SURFACE PROPERTY, NAME=p\n", "*SURFACE SMOOTHING, NAME=s\n",
        "*HCF, MAX CYCLE=1\n", "*NO ANALYSIS\n", "*SOLUTION TECHNIQUE, TYPE=QUASI-NEWTON\n",
        "*MATERIAL, NAME=spare\n*HYPERELASTIC, TEST DATA INPUT\n*UNIAXIAL TEST DATA\n1., 2.\n",
        "*BOUNDARY\nfeet, 11, 11, 20.\n"}) {
    SCOPED_TRACE(text);
    const auto mesh = read_text("a.inp", inp_with(text));
    expect_two_tets(mesh, "Lower", "upper", "Bottom");
    EXPECT_TRUE(mesh.notes.empty());
  }
}

TEST(ReadInpKeywords, OfSurfacesThatAreNotReadAreNoted) {
  for (const char* const text : {"*SURFACE, NAME=odd, TYPE=CYLINDER\n0., 0., 0., 1., 0., 0.\n",
                                 "*SURFACE, NAME=odd, COMBINE=UNION\nBottom\n", "*SURFACE, NAME=odd\n,\n"}) {
    SCOPED_TRACE(text);
    const auto mesh = read_text("a.inp", inp_with(text));
    expect_two_tets(mesh, "Lower", "upper", "Bottom");
    EXPECT_EQ(notes_that_say(mesh, "surface 'odd' ("), 1u);
    EXPECT_EQ(find_set(mesh, "odd"), nullptr);
  }
}

TEST(ReadInpKeywords, OfOneThingAreLeftOutByOneWord) {
  const std::string contact =
      "*CONTACT\n*CONTACT FORMULATION, TYPE=PURE MASTER-SLAVE\n, , MASTER\n*CONTACT STABILIZATION\n";
  const std::string connector = "*CONNECTOR BEHAVIOR, NAME=c\n*CONNECTOR ELASTICITY, COMPONENT=1\n3.\n";
  EXPECT_EQ(read_text("a.inp", inp_with(contact), {"CONTACT"}).notes.size(), 1u);
  EXPECT_EQ(read_text("a.inp", inp_with(connector), {"CONNECTORSECTION"}).notes.size(), 1u);
}

TEST(ReadInpKeywords, ThatFindNothingToChangeArePassedOver) {
  for (const char* const text :
       {"*NSET, NSET=lone\n50\n*TRANSFORM, NSET=lone, TYPE=R\n1., 1., 0., -1., 1., 0.\n", "*TEMPERATURE\nNall, 9.\n",
        "*ELSET, ELSET=none\n*SHELL SECTION, ELSET=none, MATERIAL=STEEL\n.1\n",
        "*BOUNDARY\nNall, 1, 3\n*TRANSFORM, NSET=feet, TYPE=R\n1., 1., 0., -1., 1., 0.\n"})
    EXPECT_TRUE(read_text("a.inp", inp_with(text)).notes.empty()) << text;
}

TEST(ReadInpKeywords, OfInelasticMaterialsAreNoted) {
  const auto mesh = read_text("a.inp", with(inp_text(), "*MATERIAL, NAME=rubber",
                                            "*PLASTIC\n2e8, 0.\n3e8, .1\n*CREEP\n"
                                            "1e-9, 3., 0.\n*MATERIAL, NAME=rubber"));
  EXPECT_EQ(mesh.notes.size(), 2u);
  EXPECT_EQ(notes_that_say(mesh, "a.inp:28: *PLASTIC is passed over"), 1u);
  for (const char* const law : {"SUPERELASTIC", "CONCRETE COMPRESSION HARDENING"}) {
    const auto beside = read_text("a.inp", with(inp_text(), "*DENSITY", "*" + std::string(law) + "\n1., 2.\n*DENSITY"));
    EXPECT_EQ(notes_that_say(beside, law), 1u);
    EXPECT_EQ(beside.regions[0].material.young, 2e11);
  }
}

TEST(ReadInpMaterials, OfAnotherLawAreForTheOptionsToReplace) {
  const auto law = [](const char* from, const char* to) {
    return read_text("a.inp", with(inp_text(), from, to)).regions[0].material;
  };
  for (const char* const to :
       {"*ELASTIC, TYPE=ANISOTROPIC\n1.,1.,1.,.1,.1,.1,1.,1.\n1.\n", "*ELASTIC\n2e11, 0.3, 20.\n1e11, 0.3, 90.\n",
        "*HYPERFOAM\n1., 1.\n", "*USER MATERIAL, CONSTANTS=2\n1., 2.\n"}) {
    SCOPED_TRACE(to);
    const auto material = law("*ELASTIC\n2e11, 0.3\n", to);
    EXPECT_NE(material.unread_law.find("a.inp:24: "), std::string::npos) << material.unread_law;
    EXPECT_NE(material.unread_law.find("not supported"), std::string::npos) << material.unread_law;
    EXPECT_FALSE(material.young || material.poisson);
    EXPECT_EQ(material.density, 7800);
  }
  const auto density = law("7800.,\n", "7800., 20.\n7700., 500.\n");
  EXPECT_NE(density.unread_density.find("a.inp:26: "), std::string::npos) << density.unread_density;
  EXPECT_FALSE(density.density);
  EXPECT_TRUE(density.unread_law.empty());
}

TEST(ReadInpMaterials, OfAnotherLawBesideAnElasticOneAreNotElastic) {
  for (const char* const law : {"*USER MATERIAL, CONSTANTS=2\n1., 2.\n", "*HYPERFOAM\n1., 1.\n",
                                "*ELASTIC, TYPE=ANISOTROPIC\n1.,1.,1.,1.,1.,1.,1.,1.\n1.\n"}) {
    SCOPED_TRACE(law);
    const std::string iso = "*ELASTIC\n2e11, 0.3\n";
    for (const auto& both : {iso + law, law + iso}) {
      const auto material = read_text("a.inp", with(inp_text(), iso, both)).regions[0].material;
      EXPECT_NE(material.unread_law.find("not supported"), std::string::npos);
      EXPECT_FALSE(material.young || material.poisson);
    }
  }
}

TEST(ReadInpMaterials, OfRubberBesideAnElasticLawAreRubber) {
  const std::string iso = "*ELASTIC\n2e11, 0.3\n", rubber = "*HYPERELASTIC, MOONEY-RIVLIN\n1., 1., 1.\n";
  for (const auto& both : {iso + rubber, rubber + iso}) {
    const auto material = read_text("a.inp", with(inp_text(), iso, both)).regions[0].material;
    ASSERT_TRUE(material.law);
    EXPECT_TRUE(std::holds_alternative<fem::MooneyRivlin>(*material.law));
    EXPECT_FALSE(material.young || material.poisson);
  }
}

TEST(ReadInpMaterials, WithTheSameConstantsAtAllTemperaturesAreRead) {
  auto text = with(inp_text(), "2e11, 0.3\n", "2e11, 0.3, 20.\n2e11, 0.3, 400.\n");
  text = with(text, "7800.,\n", "7800., 20.\n7800., 400.\n");
  const auto mesh = read_text("a.inp", text);
  EXPECT_EQ(mesh.regions[0].material.young, 2e11);
  EXPECT_EQ(mesh.regions[0].material.density, 7800);
  EXPECT_TRUE(mesh.regions[0].material.unread_law.empty());
}

TEST(ReadInpMaterials, AreCheckedInEveryLine) {
  EXPECT_NE(
      error_of("a.inp", with(inp_text(), "2e11, 0.3\n", "2e11, 0.3, 20.\n2e11, 0.7, 400.\n")).find(":26: Poisson"),
      std::string::npos);
  EXPECT_NE(error_of("a.inp", with(inp_text(), "2e11, 0.3\n", "2e11,, 20.\n")).find(":25: "), std::string::npos);
  EXPECT_NE(error_of("a.inp", with(inp_text(), "MATERIAL=STEEL", "COMPOSITE, MATERIAL=STEEL")).find("layered"),
            std::string::npos);
}

}  // namespace
}  // namespace ritz::readers::testing
