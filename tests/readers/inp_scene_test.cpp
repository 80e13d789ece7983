// The loads of decks as scenes: which are in effect, what they act on, what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "readers/fixture.hpp"
#include "ritz/base/error.hpp"
#include "ritz/readers/file_scene.hpp"

namespace ritz::readers::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

/// Two unit cubes, one on the other along z, in three sets; the vertex 99 belongs to neither.
const std::string cubes = R"(*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
9, 0, 0, 2
10, 1, 0, 2
11, 1, 1, 2
12, 0, 1, 2
99, 5, 5, 5
*ELEMENT, TYPE=C3D8, ELSET=Low
1, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=C3D8, ELSET=High
2, 5, 6, 7, 8, 9, 10, 11, 12
*ELSET, ELSET=Both
1, 2
*NSET, NSET=Tip
9, 10, 11, 12
*NSET, NSET=Edge
9, 10
*NSET, NSET=Lost
99
*SURFACE, NAME=Roof
High, S2
*SURFACE, NAME=Front
Both, S3
*SURFACE, NAME=Corners, TYPE=NODE
Tip
*AMPLITUDE, NAME=Blow
0., 0., 1., 2., 3., 0.
*AMPLITUDE, NAME=Clock, TIME=TOTAL TIME
1., 0., 3., 1.
*AMPLITUDE, NAME=Soft, DEFINITION=SMOOTH STEP
0., 1., 2., 3.
*AMPLITUDE, NAME=Exact, VALUE=ABSOLUTE
0., 0., 1., 5.
*AMPLITUDE, NAME=Swing, DEFINITION=PERIODIC
1, 2., 0., 0.
1., 1.
*MATERIAL, NAME=M
*ELASTIC
1e5, .3
*DENSITY
10.
*SOLID SECTION, ELSET=Both, MATERIAL=M
*BOUNDARY
1, 1, 3
)";

FileScene taken(const std::string& steps, const Ignored& ignored = {}, std::optional<int> step = {}) {
  const TemporaryFile file("scene.inp", cubes + steps);
  return read_scene(file.path(), ignored, step);
}

std::string refusal(const std::string& steps, const Ignored& ignored = {}, std::optional<int> step = {}) {
  try {
    taken(steps, ignored, step);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "was taken:\n" << steps;
  return {};
}

std::string static_step(const std::string& loads) { return "*STEP\n*STATIC\n" + loads + "*END STEP\n"; }
std::string motion(const std::string& loads) { return "*STEP\n*DYNAMIC, DIRECT\n.1, 4.\n" + loads + "*END STEP\n"; }

/// "each Tip 0 0 1" and the like, one a load.
std::vector<std::string> loads_of(const FileScene& file) {
  const auto vector = [](const scene::Vector3& v) {
    std::string text;
    for (const double x : v) text += " " + std::to_string(x).substr(0, std::to_string(x).find('.') + 2);
    return text;
  };
  std::vector<std::string> said;
  for (const auto& load : file.scene.loads) {
    const auto* const name = std::get_if<std::string>(&load.target);
    const auto on = name ? *name : "vertex " + std::to_string(std::get<std::int64_t>(load.target));
    if (const auto* f = std::get_if<scene::EachForce>(&load.kind)) said.push_back("each " + on + vector(f->newton));
    if (const auto* p = std::get_if<scene::Pressure>(&load.kind))
      said.push_back("pressure " + on + vector({p->pascal}).substr(0, 4));
    if (const auto* t = std::get_if<scene::Traction>(&load.kind)) said.push_back("traction " + on + vector(t->pascal));
  }
  return said;
}

TEST(DeckScene, Forces) {
  const auto file = taken(static_step("*CLOAD\ntip, 3, -2.\nTIP, 1, 1.\n7, 2, 3.\n*CLOAD, AMPLITUDE=BLOW\n7, 2, 1.\n"));
  EXPECT_THAT(loads_of(file),
              ElementsAre("each Tip 1.0 0.0 -2.0", "each vertex 7 0.0 3.0 0.0", "each vertex 7 0.0 1.0 0.0"));
  EXPECT_FALSE(file.scene.loads[0].table);
  EXPECT_THAT(file.scene.loads[2].table->points, ElementsAre(Pair(0, 0), Pair(1, 2), Pair(3, 0)));
  EXPECT_EQ(std::get<scene::Static>(file.scene.analysis).steps, 1);
  EXPECT_THAT(file.step, AllOf(HasSubstr("step 1 (*STATIC)"), HasSubstr("scene.inp:")));
}

TEST(DeckScene, FacesOfElementsAreSurfacesOfTheMesh) {
  const auto steps = static_step("*DLOAD\nHigh, P2, 5.\n1, P1, 2.\n2, P3, 2.\n1, P3, 4.\n1, P3, 4.\n") +
                     static_step("*DLOAD, OP=NEW\nhigh, p2, 7.\n2, P2, 1.\n*DSLOAD, OP=NEW\nRoof, P, 3.\n");
  EXPECT_THAT(loads_of(taken(steps, {}, 1)), ElementsAre("pressure High.P2 5.0", "pressure DLOAD-1 2.0",
                                                         "pressure DLOAD-1.2 4.0", "pressure DLOAD-1.3 4.0"));
  EXPECT_THAT(loads_of(taken(steps)), ElementsAre("pressure High.P2 7.0", "pressure DLOAD-2 1.0", "pressure Roof 3.0"));
  const auto mesh = read_text("faces.inp", cubes + steps);
  const std::map<std::string, std::vector<std::size_t>> expected = {
      {"High.P2", {1}}, {"DLOAD-1", {2}}, {"DLOAD-1.2", {1}}, {"DLOAD-1.3", {1}}, {"DLOAD-2", {1}}, {"Roof", {1}}};
  for (const auto& [name, faces] : expected) {
    ASSERT_TRUE(find_set(mesh, name)) << name;
    EXPECT_EQ(find_set(mesh, name)->faces.size(), faces[0]) << name;
  }
  EXPECT_EQ(find_set(mesh, "High.P2")->vertices, (std::vector<Index>{8, 9, 10, 11}));
}

TEST(DeckScene, ANameThatASurfaceHas) {
  const auto steps = "*SURFACE, NAME=HIGH.P2\nLow, S1\n" + static_step("*DLOAD\nHigh, P2, 5.\n");
  EXPECT_THAT(loads_of(taken(steps)), ElementsAre("pressure High.P2' 5.0"));
}

// The name that means the set to a force may mean another set to a pressure.
TEST(DeckScene, NamesOfSeveralKinds) {
  const auto steps = "*NSET, NSET=Roof\n9\n" + static_step("*CLOAD\nRoof, 1, 1.\n*DSLOAD\nRoof, P, 2.\n");
  EXPECT_THAT(loads_of(taken(steps)), ElementsAre("each nset:Roof 1.0 0.0 0.0", "pressure surface:Roof 2.0"));
}

TEST(DeckScene, Instances) {
  const std::string steps = static_step("*CLOAD\nA-1.Tip, 1, 1.\nA-2.7, 2, 1.\n*DLOAD\nA-2.High, P2, 3.\n");
  const auto part = cubes.substr(0, cubes.find("*AMPLITUDE"));
  const auto rest = cubes.substr(cubes.find("*MATERIAL"), cubes.find("*SOLID") - cubes.find("*MATERIAL"));
  const TemporaryFile file("parts.inp",
                           "*PART, NAME=A\n" + part + "*SOLID SECTION, ELSET=Both, MATERIAL=M\n*END PART\n" +
                               "*ASSEMBLY, NAME=S\n*INSTANCE, NAME=A-1, PART=A\n*END INSTANCE\n" +
                               "*INSTANCE, NAME=A-2, PART=A\n0, 0, 9\n*END INSTANCE\n*END ASSEMBLY\n" + rest + steps);
  EXPECT_THAT(loads_of(read_scene(file.path())),
              ElementsAre("each A-1.Tip 1.0 0.0 0.0", "each vertex 106 0.0 1.0 0.0", "pressure A-2.High.P2 3.0"));
  EXPECT_TRUE(find_set(read_file(file.path()), "A-2.High.P2"));
}

TEST(DeckScene, GravityOfAllElements) {
  const auto all = taken(static_step("*DLOAD\nBoth, GRAV, 10., 0., 0., -2.\n"));
  EXPECT_EQ(all.scene.gravity, (scene::Vector3{0, 0, -10}));
  const auto parts = taken(static_step("*DLOAD\nLow, GRAV, 10., 0., 3., -4.\n2, GRAV, 10., 0., .3, -.4\n"));
  EXPECT_NEAR((*parts.scene.gravity)[1], 6, 1e-12);
  EXPECT_NEAR((*parts.scene.gravity)[2], -8, 1e-12);
  EXPECT_EQ(taken(static_step("*DLOAD\n, GRAV, 10., 1., 0., 0.\nBoth, GRAV, 2., 1., 0., 0.\n")).scene.gravity,
            (scene::Vector3{12, 0, 0}));
  EXPECT_THAT(refusal(static_step("*DLOAD\nLow, GRAV, 10., 0., 0., -1.\n")), HasSubstr("a part of the body"));
  EXPECT_THAT(refusal(static_step("*DLOAD\nBoth, GRAV, 10.\n")), HasSubstr("direction"));
}

TEST(DeckScene, GravityThatChanges) {
  const auto shaken = taken(motion("*DLOAD, AMPLITUDE=Blow\nBoth, GRAV, 10., 0., 0., -1.\n"));
  EXPECT_FALSE(shaken.scene.gravity);
  EXPECT_EQ(shaken.scene.shake->direction, (scene::Vector3{0, 0, 10}));
  EXPECT_THAT(shaken.scene.shake->table.points, ElementsAre(Pair(0, 0), Pair(1, 2), Pair(3, 0)));
  EXPECT_THAT(shaken.notes, ElementsAre(HasSubstr("linear"), HasSubstr("shaking")));
  const auto still = taken("*STEP\n*STATIC\n1., 2.\n*DLOAD, AMPLITUDE=Blow\nBoth, GRAV, 10., 0., 0., -1.\n*END STEP\n");
  EXPECT_EQ(still.scene.gravity, (scene::Vector3{0, 0, -10})) << "the amplitude is 1 at the end of the step, at 2";
}

TEST(DeckScene, Tractions) {
  EXPECT_THAT(loads_of(taken(static_step("*DSLOAD\nRoof, TRVEC, 5., 0., -2., 0.\n"))),
              ElementsAre("traction Roof 0.0 -5.0 0.0"));
}

TEST(DeckScene, Analyses) {
  const auto increments = taken("*STEP, NLGEOM\n*STATIC\n.1, 2.\n*CLOAD\nTip, 1, 1.\n*END STEP\n");
  EXPECT_EQ(std::get<scene::Static>(increments.scene.analysis).steps, 20);
  EXPECT_THAT(increments.notes, IsEmpty());
  const auto moves = taken(motion("*CLOAD\nTip, 1, 1.\n"));
  const auto& time = std::get<scene::Time>(moves.scene.analysis);
  EXPECT_EQ(time.step, .1);
  EXPECT_EQ(time.end, 4);
  EXPECT_FALSE(moves.scene.loads[0].table) << "there at once";
  const auto modal =
      taken("*STEP\n*FREQUENCY\n3\n*END STEP\n*STEP\n*MODAL DYNAMIC\n.5, 1.\n*CLOAD\nTip, 1, 1.\n*END STEP\n");
  EXPECT_EQ(std::get<scene::Time>(modal.scene.analysis).step, .5);
}

TEST(DeckScene, RampsAndSteps) {
  const auto table = [](const std::string& step) {
    return taken(step + "*CLOAD\nTip, 1, 1.\n*END STEP\n").scene.loads[0].table;
  };
  EXPECT_THAT(table("*STEP, AMPLITUDE=RAMP\n*DYNAMIC\n.1, 4.\n")->points, ElementsAre(Pair(0, 0), Pair(4, 1)));
  EXPECT_THAT(table("*STEP, AMPLITUDE=STEP\n*STATIC\n")->points, ElementsAre(Pair(0, 1)));
  EXPECT_FALSE(table("*STEP, AMPLITUDE=STEP\n*DYNAMIC\n.1, 4.\n"));
  EXPECT_THAT(table("*STEP\n*DYNAMIC, APPLICATION=QUASI-STATIC\n.1, 4.\n")->points,
              ElementsAre(Pair(0, 0), Pair(4, 1)));
}

TEST(DeckScene, Amplitudes) {
  const auto table = [](const std::string& name, const std::string& before = "") {
    return *taken(before + "*STEP\n*STATIC\n1., 2.\n*CLOAD, AMPLITUDE=" + name + "\nTip, 1, 1.\n*END STEP\n")
                .scene.loads[0]
                .table;
  };
  EXPECT_THAT(table("blow").points, ElementsAre(Pair(0, 0), Pair(.5, 2), Pair(1.5, 0))) << "over fractions of the step";
  EXPECT_THAT(table("Clock", static_step("")).points, ElementsAre(Pair(0, 0), Pair(1, 1))) << "the first step took 1";
  const auto soft = table("Soft");
  EXPECT_EQ(soft.points.size(), 51u);
  for (double x = 0; x <= 1; x += 1. / 128)
    EXPECT_NEAR(soft.at(x), 1 + 2 * x * x * x * (10 - 15 * x + 6 * x * x), 2 * 3e-4) << x;
  EXPECT_THAT(table("Exact").points, ElementsAre(Pair(0, 0), Pair(.5, 5)));
  EXPECT_THAT(table("Late", "*AMPLITUDE, NAME=Late, SHIFTX=1., SHIFTY=-1.\n0., 1., 1., 2.\n").points,
              ElementsAre(Pair(.5, 0), Pair(1, 1)));
}

struct InEffect {
  const char* what;
  std::string first, second;
  std::vector<std::string> loads;
};

const InEffect in_effect[] = {
    {"another load is kept", "*CLOAD\nTip, 1, 1.\n", "*CLOAD\nTip, 2, 2.\n", {"each Tip 1.0 2.0 0.0"}},
    {"the same load is replaced", "*CLOAD\nTip, 1, 1.\n", "*CLOAD\nTip, 1, 2.\n", {"each Tip 2.0 0.0 0.0"}},
    {"a larger set replaces", "*CLOAD\nEdge, 1, 1.\n", "*CLOAD\nTip, 1, 2.\n", {"each Tip 2.0 0.0 0.0"}},
    {"a load of nothing takes one back",
     "*CLOAD\nTip, 1, 1.\n7, 1, 1.\n",
     "*CLOAD\nTip, 1, 0.\n",
     {"each vertex 7 1.0 0.0 0.0"}},
    {"two loads of a step add up", "", "*CLOAD\nTip, 1, 1.\nTip, 1, 2.\n", {"each Tip 3.0 0.0 0.0"}},
    {"OP=NEW removes forces alone",
     "*CLOAD\nTip, 1, 1.\n*DSLOAD\nRoof, P, 1.\n",
     "*CLOAD, OP=NEW\nTip, 2, 2.\n",
     {"pressure Roof 1.0", "each Tip 0.0 2.0 0.0"}},
    {"a pressure is replaced by that of the same faces",
     "*DLOAD\nHigh, P2, 1.\n",
     "*DLOAD\n2, P2, 4.\n",
     {"pressure DLOAD-1 4.0"}},
    {"OP=NEW of pressures", "*DSLOAD\nRoof, P, 1.\n", "*DSLOAD, OP=NEW\nRoof, P, 2.\n", {"pressure Roof 2.0"}}};

TEST(DeckScene, LoadsOfEarlierSteps) {
  for (const auto& [what, first, second, expected] : in_effect) {
    SCOPED_TRACE(what);
    const auto file = taken(static_step(first) + static_step(second));
    EXPECT_EQ(loads_of(file), expected);
    EXPECT_THAT(file.step, HasSubstr("step 2"));
  }
}

struct Refused {
  const char* said;
  std::string steps;
  const char* word = "";  ///< of -ignore, with which it is left out
};

const Refused refused[] = {
    {"no step of the deck", "*STEP\n*FREQUENCY\n3\n*END STEP\n"},
    {"outside of the steps", "*CLOAD\nTip, 1, 1.\n" + static_step("")},
    {"no node set and no node", static_step("*CLOAD\nNobody, 1, 1.\n")},
    {"no node set and no node", static_step("*CLOAD\nBoth, 1, 1.\n")},
    {"degree of freedom", static_step("*CLOAD\nTip\n")},
    {"a magnitude", static_step("*CLOAD\nTip, 1\n")},
    {"a magnitude", static_step("*CLOAD\nTip, 1, much\n")},
    {"more fields", static_step("*CLOAD\nTip, 1, 1., 2.\n")},
    {"no solid element has a node", static_step("*CLOAD\nLost, 1, 1.\n"), "CLOAD"},
    {"no element set and no element", static_step("*DLOAD\nTip, P2, 1.\n")},
    {"no surface", static_step("*DSLOAD\nTip, P, 1.\n")},
    {"other parts than faces", static_step("*DSLOAD\nCorners, P, 1.\n")},
    {"between two elements", static_step("*DLOAD\nBoth, P2, 1.\n")},
    {"'BX'", static_step("*DLOAD\nBoth, BX, 1.\n"), "BX"},
    {"'CENTRIF'", static_step("*DLOAD\nBoth, CENTRIF, 1., 0., 0., 0., 0., 0., 1.\n"), "CENTRIF"},
    {"'P7'", static_step("*DLOAD\nBoth, P7, 1.\n")},
    {"'FOLLOWER'", static_step("*CLOAD, FOLLOWER\nTip, 1, 1.\n"), "FOLLOWER"},
    {"no amplitude 'None'", static_step("*CLOAD, AMPLITUDE=None\nTip, 1, 1.\n")},
    {"DEFINITION=", static_step("*CLOAD, AMPLITUDE=Swing\nTip, 1, 1.\n")},
    {"VALUE=ABSOLUTE", static_step("*CLOAD, AMPLITUDE=Exact\nTip, 1, 2.\n")},
    {"more than one amplitude",
     "*AMPLITUDE, NAME=Blow\n0., 1.\n" + static_step("*CLOAD, AMPLITUDE=Blow\nTip, 1, 2.\n")},
    {"ascend", "*AMPLITUDE, NAME=Back\n1., 1., 0., 1.\n" + static_step("*CLOAD, AMPLITUDE=Back\nTip, 1, 2.\n")},
    {"pairs", "*AMPLITUDE, NAME=Odd\n1., 1., 2.\n" + static_step("*CLOAD, AMPLITUDE=Odd\nTip, 1, 2.\n")},
    {"time increment", "*STEP\n*DYNAMIC, EXPLICIT\n, 1.\n*CLOAD\nTip, 1, 1.\n*END STEP\n"},
    {"TOTAL TIME counts", "*STEP\n*FREQUENCY\n3\n*END STEP\n" + static_step("*CLOAD, AMPLITUDE=Clock\nTip, 1, 1.\n")},
    {"RIKS", "*STEP\n*STATIC, RIKS\n*CLOAD\nTip, 1, 1.\n*END STEP\n"},
    {"begins where step 1", static_step("*CLOAD\nTip, 1, 1.\n") + motion("")},
    {"in another way", static_step("*CLOAD\nTip, 1, 1.\n") + static_step("*CLOAD\nEdge, 1, 2.\n")},
    {"in another way", static_step("*DLOAD\nHigh, P2, 1.\n") + static_step("*DSLOAD\nRoof, P, 2.\n")},
    {"in another way",
     static_step("*DLOAD\nBoth, GRAV, 1., 0., 0., 1.\n") + static_step("*DLOAD\nBoth, GRAV, 1., 1., 0., 0.\n")},
    {"OP=NEW of *DLOAD and of *DSLOAD",
     static_step("*DLOAD\nHigh, P2, 1.\n") + static_step("*DSLOAD, OP=NEW\nFront, P, 2.\n")},
    {"of all or of none", static_step("") + static_step("*CLOAD\nTip, 1, 1.\n*CLOAD, OP=NEW\nTip, 2, 1.\n")},
    {"its amplitude then does",
     static_step("*CLOAD, AMPLITUDE=Blow\nTip, 1, 1.\n") + static_step("*CLOAD\nTip, 2, 1.\n")},
    {"*BOUNDARY, FIXED",
     static_step("*CLOAD\nTip, 1, 1.\n") + static_step("*CLOAD, OP=NEW\nTip, 2, 0.\n*BOUNDARY, FIXED\n2, 1\n"),
     "BOUNDARY"},
    {"*TRANSFORM turns", "*TRANSFORM, NSET=Tip\n0., 1., 0., 1., 0., 0.\n" + static_step("*CLOAD\n9, 1, 1.\n")},
    {"*BASE MOTION", motion("*BASE MOTION, DOF=1, AMPLITUDE=Blow\n"), "BASEMOTION"},
    {"*INITIAL CONDITIONS", "*INITIAL CONDITIONS, TYPE=VELOCITY\nTip, 1, 1.\n" + motion(""), "INITIALCONDITIONS"},
    {"prescribed displacement", static_step("*BOUNDARY\nTip, 1, 1, .1\n") + "*STEP\n*FREQUENCY\n3\n*END STEP\n",
     "BOUNDARY"}};

TEST(DeckScene, WhatIsRefused) {
  for (const auto& [said, steps, word] : refused) {
    SCOPED_TRACE(steps);
    const auto sentence = refusal(steps);
    EXPECT_THAT(sentence, AllOf(HasSubstr(said), HasSubstr("scene.inp")));
    EXPECT_NO_THROW(read_text("mesh.inp", cubes + steps, *word ? Ignored{word} : Ignored{}))
        << "the mesh minds no loads";
    if (!*word) continue;
    EXPECT_THAT(sentence, HasSubstr("-ignore " + std::string(word)));
    const auto file = taken(steps, {word});
    EXPECT_THAT(file.scene.loads, IsEmpty());
    EXPECT_THAT(file.notes, ::testing::Contains(AllOf(HasSubstr(said), HasSubstr("left out"))));
  }
}

TEST(DeckScene, StepsByNumber) {
  const auto steps = static_step("*CLOAD\nTip, 1, 1.\n") + static_step("*CLOAD\nTip, 1, 2.\n");
  EXPECT_THAT(loads_of(taken(static_step("*BOUNDARY, FIXED\n2, 1\n*CLOAD\nTip, 1, 1.\n"))),
              ElementsAre("each Tip 1.0 0.0 0.0"))
      << "nothing has moved what is fixed";
  EXPECT_THAT(loads_of(taken(steps, {}, 1)), ElementsAre("each Tip 1.0 0.0 0.0"));
  EXPECT_THAT(refusal(steps, {}, 3), HasSubstr("no step 3; it has 2"));
  EXPECT_THAT(refusal(steps, {}, 0), HasSubstr("no step 0"));
  EXPECT_THAT(refusal(steps + "*STEP\n*FREQUENCY\n1\n*END STEP\n", {}, 3), HasSubstr("step 3 is not"));
}

TEST(DeckScene, WhatIsNoted) {
  const auto noted = [](const std::string& steps) { return taken(steps).notes; };
  using ::testing::Contains;
  EXPECT_THAT(noted(static_step("*CLOAD\nTip, 4, 1.\n")), Contains(HasSubstr("beyond 3")));
  EXPECT_THAT(noted(static_step("")), Contains(HasSubstr("no loads")));
  EXPECT_THAT(noted(static_step("*TEMPERATURE\nTip, 3.\n*DFLUX\nBoth, BF, 1.\n")),
              AllOf(Contains(HasSubstr("*TEMPERATURE")), Contains(HasSubstr("*DFLUX"))));
  EXPECT_THAT(noted("*STEP, NLGEOM\n*STATIC\n*DSLOAD\nRoof, P, 1.\n*END STEP\n"), ElementsAre(HasSubstr("follows")));
  EXPECT_THAT(noted("*STEP\n*DYNAMIC, ALPHA=-.1\n.1, 1.\n*DAMPING, ALPHA=1.\n*END STEP\n"),
              AllOf(Contains(HasSubstr("'ALPHA' of *DYNAMIC")), Contains(HasSubstr("adapt")),
                    Contains(HasSubstr("[damping]"))));
  EXPECT_THAT(noted(static_step("*CLOAD\nTip, 1, 1.\n") + static_step("*CLOAD\nTip, 2, 1.\n")),
              Contains(HasSubstr("the way there another")));
  EXPECT_THAT(noted(static_step("") + "*STEP\n*FREQUENCY\n1\n*BOUNDARY, OP=NEW\n2, 1\n*END STEP\n"),
              Contains(HasSubstr("other supports than step 2")));
}

TEST(DeckScene, DecksAlone) {
  const TemporaryFile file("scene.msh", "");
  EXPECT_THAT([&] { read_scene(file.path()); }, ::testing::ThrowsMessage<InputError>(HasSubstr("(.inp) alone")));
}

}  // namespace
}  // namespace ritz::readers::testing
