// Material laws that mesh files state: *HYPERELASTIC, orthotropic *ELASTIC with *ORIENTATION, and Vega's own.
#include "readers/fixture.hpp"

namespace ritz::readers::testing {
namespace {

using ::testing::HasSubstr;

const std::string isotropic = "*ELASTIC\n2e11, 0.3\n";

/// The material of the first region of a deck whose *ELASTIC is replaced.
FileMaterial material_of(const std::string& law) {
  const auto mesh = read_text("a.inp", with(inp_text(), isotropic, law));
  return mesh.regions[0].material;
}

std::vector<double> values(const FileMaterial& material) {
  std::vector<double> all;
  for (const auto& given : fem::parameters(material.law.value())) all.push_back(given.value);
  return all;
}

template <class Law>
void expect_law(const std::string& deck, const Law& law) {
  const auto material = material_of(deck);
  ASSERT_TRUE(material.law) << deck << material.unread_law;
  EXPECT_STREQ(fem::name(*material.law), Law::name) << deck;
  const auto expected = law.values();
  EXPECT_EQ(values(material), std::vector<double>(expected.begin(), expected.end())) << deck;
  EXPECT_EQ(material.density, 7800);
}

TEST(InpLaws, AreThoseOfHyperelastic) {
  expect_law("*HYPERELASTIC, MOONEY-RIVLIN\n1.5e5, 4e4, 2e-6\n", fem::MooneyRivlin{1.5e5, 4e4, 2e-6});
  expect_law("*HYPERELASTIC\n1.5e5, 4e4, 2e-6, 293.\n", fem::MooneyRivlin{1.5e5, 4e4, 2e-6});
  expect_law("*Hyperelastic, polynomial, N=1\n1.5e5, , 2e-6\n", fem::MooneyRivlin{1.5e5, 0, 2e-6});
  expect_law("*HYPERELASTIC, YEOH\n1.5e5, -2e3, 1e2, 2e-6, 1e30, 1e31\n",
             fem::Yeoh{1.5e5, -2e3, 1e2, 2e-6, 1e30, 1e31});
  expect_law("*HYPERELASTIC, REDUCED POLYNOMIAL, N=2\n1.5e5, 2e3, 2e-6, 3\n", fem::Yeoh{1.5e5, 2e3, 0, 2e-6, 3, 0});
  expect_law("*HYPERELASTIC, REDUCED POLYNOMIAL, N=3\n1.5e5, 2e3, 1, 2e-6\n", fem::Yeoh{1.5e5, 2e3, 1, 2e-6, 0, 0});
  expect_law("*HYPERELASTIC, ARRUDA-BOYCE\n3.5e5, 2.5, 2e-6\n", fem::ArrudaBoyce{3.5e5, 2.5, 2e-6});
  expect_law("*HYPERELASTIC, OGDEN\n6.3e5, 1.3, 2e-6\n", fem::Ogden{.mu1 = 6.3e5, .alpha1 = 1.3, .d1 = 2e-6});
  expect_law("*HYPERELASTIC, OGDEN, N=2\n6.3e5, 1.3, 1.2e3, 5, 2e-6\n",
             fem::Ogden{.mu1 = 6.3e5, .alpha1 = 1.3, .mu2 = 1.2e3, .alpha2 = 5, .d1 = 2e-6});
  expect_law("*HYPERELASTIC, OGDEN, N=3\n6.3e5, 1.3, 1.2e3, 5, -1e4, -2, 2e-6, 1e30\n1e31, 293.\n",
             fem::Ogden{6.3e5, 1.3, 1.2e3, 5, -1e4, -2, 2e-6, 1e30, 1e31});
}

// C10 and D are half the shear modulus and two over the bulk modulus.
TEST(InpLaws, OfNeoHookeGiveYoungAndPoissonToo) {
  const auto material = material_of("*HYPERELASTIC, NEO HOOKE\n2e5, 2e-6\n");
  const auto rest = std::get<fem::IsochoricNeoHookean>(material.law.value()).at_rest();
  EXPECT_NEAR(rest.mu, 4e5, 1e-9);
  EXPECT_NEAR(rest.lambda + 2. / 3 * rest.mu, 1e6, 1e-8);
  EXPECT_EQ(material.young, values(material)[0]);
  EXPECT_EQ(material.poisson, values(material)[1]);
}

TEST(InpLaws, ThatAreNotReadAreLeftToTheOptions) {
  for (const std::string law :
       {"*HYPERELASTIC, MARLOW\n1, 2\n", "*HYPERELASTIC, OGDEN, N=4\n1, 2, 3, 4, 5, 6, 7, 8\n1, 1\n",
        "*HYPERELASTIC, N=2\n1, 2, 3, 4, 5, 6, 7\n", "*HYPERELASTIC, YEOH, TEST DATA INPUT\n",
        "*HYPERELASTIC, NEO HOOKE\n1e5, 1e-6, 20\n2e5, 1e-6, 40\n", "*ELASTIC, TYPE=ANISO\n1, 2\n"}) {
    const auto material = material_of(law);
    EXPECT_FALSE(material.law || material.young) << law;
    EXPECT_THAT(material.unread_law, HasSubstr("not supported")) << law;
  }
}

std::string error_of_law(const std::string& law) { return error_of("a.inp", with(inp_text(), isotropic, law)); }

TEST(InpLaws, MustBePossible) {
  EXPECT_THAT(error_of_law("*HYPERELASTIC, NEO HOOKE\n1e5, 0\n"), HasSubstr("incompressible"));
  EXPECT_THAT(error_of_law("*HYPERELASTIC, NEO HOOKE\n1e5\n"), HasSubstr("incompressible"));
  EXPECT_THAT(error_of_law("*HYPERELASTIC, MOONEY-RIVLIN\n1e5, -2e5, 1e-6\n"), HasSubstr("shear modulus at rest"));
  EXPECT_THAT(error_of_law("*HYPERELASTIC, ARRUDA-BOYCE\n-1, 2, 1e-6\n"), HasSubstr("mu"));
  EXPECT_THAT(error_of_law("*HYPERELASTIC, OGDEN, N=3\n1, 2, 3, 4, 5, 6, 7, 8\n"), HasSubstr("two lines"));
  EXPECT_THAT(error_of_law("*ELASTIC, TYPE=ENGINEERING CONSTANTS\n1, 1, 1, .9, .9, .9, 1, 1\n1\n"),
              HasSubstr("stiffness at rest"));
  EXPECT_THAT(error_of_law("*ELASTIC, TYPE=ORTHO\n1, 1, 1, .9, .9, .9, 1, 1\n"), HasSubstr("two lines"));
}

const std::string engineering = "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n1e6, 5e5, 2e5, .3, .25, .2, 3e5, 2e5\n1e5\n";

TEST(InpLaws, OfOrthotropicBodiesHaveTheAxesOfTheCoordinates) {
  expect_law(engineering, *fem::OrthotropicStVK::of_constants(std::array{1e6, 5e5, 2e5, .3, .25, .2, 3e5, 2e5, 1e5}));
}

// D1111 and so on are the inverse of the compliance.
TEST(InpLaws, MayBeGivenByTheirStiffness) {
  const auto law = *fem::OrthotropicStVK::of_constants(std::array{1e6, 5e5, 2e5, .3, .25, .2, 3e5, 2e5, 1e5});
  const auto C = law.at_rest().hooke();
  std::ostringstream text;
  text.precision(17);
  text << "*ELASTIC, TYPE=ORTHO\n"
       << C(0, 0) << ", " << C(0, 1) << ", " << C(1, 1) << ", " << C(0, 2) << ", " << C(1, 2) << ", " << C(2, 2)
       << ", 3e5, 2e5\n1e5\n";
  const auto found = values(material_of(text.str()));
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], law.values()[i], 1e-12 * std::max(1., std::abs(law.values()[i])));
}

TEST(InpLaws, TurnWithTheOrientationOfTheSection) {
  auto text = with(inp_text(), isotropic, engineering);
  text = with(text, "ELSET=LOWER, MATERIAL=STEEL\n", "ELSET=LOWER, MATERIAL=STEEL, ORIENTATION=Turned\n");
  const auto turned = [&](const std::string& orientation) {
    return with(text, "*MATERIAL, NAME=Steel\n", orientation + "*MATERIAL, NAME=Steel\n");
  };
  const auto axes =
      values(read_text("a.inp", turned("*ORIENTATION, NAME=TURNED\n1, 3, 1, 0, 2, 1, 0, 2, 0\n")).regions[0].material);
  EXPECT_THAT(std::vector<double>(axes.end() - 6, axes.end()), ::testing::ElementsAre(1, 1, 1, 0, 0, 1));
  EXPECT_THAT(read_text("a.inp", turned("*ORIENTATION, NAME=TURNED, SYSTEM=CYLINDRICAL\n0, 0, 0, 0, 0, 1\n"))
                  .regions[0]
                  .material.unread_law,
              HasSubstr("RECTANGULAR"));
  EXPECT_THAT(read_text("a.inp", turned("*ORIENTATION, NAME=TURNED\n1, 0, 0, 0, 1, 0\n3, 30.\n"))
                  .regions[0]
                  .material.unread_law,
              HasSubstr("rotation"));
  EXPECT_THAT(error_of("a.inp", turned("*ORIENTATION, NAME=TURNED\n1, 0, 0, 2, 0, 0\n")), HasSubstr("parallel"));
  EXPECT_THAT(error_of("a.inp", text), HasSubstr("not defined"));
}

FileMaterial of_vega(const std::string& law) {
  return read_text("a.veg", with(veg_text(), "ENU, 7800, 2e11, 0.3", law)).regions[0].material;
}

TEST(VegaLaws, AreReadInVegasOrder) {
  EXPECT_EQ(values(of_vega("MOONEYRIVLIN, 7800, 1, 2, 4")), (std::vector<double>{2, 1, .25}));
  EXPECT_EQ(values(of_vega("ORTHOTROPIC, 7800, 8, 4, 2, .3, .2, .1, 3, 2, 1")),
            (std::vector<double>{8, 4, 2, .3, .4, .2, 3, 1, 2, 1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(values(of_vega("ORTHOTROPIC_N3G3R9, 7800, 8, 4, 2, .3, .2, .1, 3, 2, 1, 0, -1, 0, 1, 0, 0, 0, 0, 1")),
            (std::vector<double>{8, 4, 2, .3, .4, .2, 3, 1, 2, 0, 1, 0, -1, 0, 0}));
  EXPECT_EQ(of_vega("MOONEYRIVLIN, 7800, 1, 2, 4").density, 7800);
}

TEST(VegaLaws, MustBePossible) {
  const auto error = [](const std::string& law) {
    return error_of("a.veg", with(veg_text(), "ENU, 7800, 2e11, 0.3", law));
  };
  EXPECT_THAT(error("MOONEYRIVLIN, 7800, 1, 2"), HasSubstr(":16"));
  EXPECT_THAT(error("MOONEYRIVLIN, 7800, -3, 2, 4"), HasSubstr("shear modulus"));
  EXPECT_THAT(error("ORTHOTROPIC, 7800, 8, 4, 2, .3, .2, .1, 3, 2"), HasSubstr(":16"));
  EXPECT_THAT(error("ORTHOTROPIC, 7800, 8, 4, 2, .3, .2, .1, 3, 2, -1"), HasSubstr("cannot be"));
}

}  // namespace
}  // namespace ritz::readers::testing
