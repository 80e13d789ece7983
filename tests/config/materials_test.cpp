// Whose material a region gets: its own option, the general option, the mesh file; in SI.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/configured.hpp"
#include "ritz/base/error.hpp"

namespace ritz::config {
namespace {

using config::testing::with_box;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::vector<mesh::Region> regions = {{"Steel", {200e9, .29, 7850}}, {"rubber", {}}};
const std::vector<std::string> general = {"-material_young",   "1e6", "-material_poisson", ".45",
                                          "-material_density", "1100"};

struct Constants {
  double young, poisson, density;
};

std::vector<Constants> constants(const Config& config, const std::vector<mesh::Region>& of) {
  std::vector<Constants> all;
  for (const auto& [law, density] : region_materials(config, of)) {
    const auto told = fem::parameters(law);
    all.push_back({told.at(0).value, told.at(1).value, density});
  }
  return all;
}

std::vector<Constants> materials(std::vector<std::string> words) {
  return constants(with_box(std::move(words)), regions);
}

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Materials, OfTheGeneralOptionsWinOverTheFile) {
  for (const auto& m : materials(general)) {
    EXPECT_EQ(m.young, 1e6);
    EXPECT_EQ(m.poisson, .45);
    EXPECT_EQ(m.density, 1100);
  }
}

TEST(Materials, OfARegionWinOverTheGeneral) {
  const auto all = materials(with(general, {"-material_rubber_young", "2e6", "-material_steel_density", "7000"}));
  EXPECT_EQ(all[0].young, 1e6);
  EXPECT_EQ(all[0].density, 7000);  // names of options do not mind capitals
  EXPECT_EQ(all[1].young, 2e6);
  EXPECT_EQ(all[1].density, 1100);
}

TEST(Materials, OfTheFileStandWhereNoOptionSpeaks) {
  const auto all = materials({"-material_rubber_young", "2e6", "-material_rubber_poisson", ".4",
                              "-material_rubber_density", "1000", "-material_Steel_poisson", ".3"});
  EXPECT_EQ(all[0].young, 200e9);
  EXPECT_EQ(all[0].poisson, .3);
  EXPECT_EQ(all[0].density, 7850);
  EXPECT_EQ(all[1].poisson, .4);
}

// 'core' lies in 'rubber', which lies in 'all'.
const std::vector<mesh::Region> nested = {{"all", {}}, {"rubber", {}, {"all"}}, {"core", {}, {"rubber", "all"}}};

TEST(Materials, OfASmallerVolumeWinOverThoseItLiesIn) {
  const auto m = constants(with_box(with(general, {"-material_all_young", "2e11", "-material_rubber_young", "1e7",
                                                   "-material_all_density", "7800", "-material_core_density", "900"})),
                           nested);
  EXPECT_EQ(m[0].young, 2e11);
  EXPECT_EQ(m[1].young, 1e7);
  EXPECT_EQ(m[2].young, 1e7);
  EXPECT_EQ(m[0].density, 7800);
  EXPECT_EQ(m[1].density, 7800);
  EXPECT_EQ(m[2].density, 900);
  for (const auto& material : m) EXPECT_EQ(material.poisson, .45);
}

TEST(Materials, OfVolumesThatCrossMustAgree) {
  const std::vector<mesh::Region> crossing = {{"a", {}}, {"b", {}}, {"a & b", {}, {"a", "b"}, mesh::Overlap::crossing}};
  const auto of = [&](const std::vector<std::string>& more) {
    return constants(with_box(with(general, more)), crossing)[2].young;
  };
  EXPECT_EQ(of({}), 1e6);
  EXPECT_EQ(of({"-material_b_young", "3e6"}), 3e6);
  EXPECT_EQ(of({"-material_a_young", "3e6", "-material_b_young", "3e6"}), 3e6);
  EXPECT_EQ(of({"-material_a_young", "2e6", "-material_b_young", "3e6", "-material_a_&_b_young", "4e6"}), 4e6);
  EXPECT_THAT(
      [&] {
        of({"-material_a_young", "2e6", "-material_b_young", "3e6"});
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("'a' or 'b'"), HasSubstr("-material_a_&_b_young"))));
}

TEST(Materials, OfVolumesOfTheSameCellsMustAgree) {
  const std::vector<mesh::Region> same = {{"a", {}, {"a", "b"}, mesh::Overlap::crossing}};
  EXPECT_EQ(constants(with_box(with(general, {"-material_a_young", "3e6"})), same)[0].young, 3e6);
  EXPECT_EQ(constants(with_box(with(general, {"-material_b_young", "3e6"})), same)[0].young, 3e6);
  EXPECT_THAT(
      [&] {
        constants(with_box(with(general, {"-material_a_young", "2e6", "-material_b_young", "3e6"})), same);
      },
      ThrowsMessage<InputError>(HasSubstr("give these the same value")));
}

TEST(Materials, OfAFileAndOfOptionsCompleteEachOther) {
  const std::vector<mesh::Region> partly = {{"steel", {.young = 2e11, .poisson = .3}}};
  const auto all = constants(with_box({"-material_density", "7800"}), partly);
  EXPECT_EQ(all[0].young, 2e11);
  EXPECT_EQ(all[0].density, 7800);
  EXPECT_THAT([&] { constants(with_box({}), partly); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("'steel' has no density"), HasSubstr("-material_density"))));
}

TEST(Materials, OfOptionsGetPastALawThatIsNotRead) {
  const std::vector<mesh::Region> ortho = {{"wood", {.density = 700, .unread_law = "w.veg:9: law ORTHOTROPIC"}}};
  const auto all = constants(with_box({"-material_young", "1e10", "-material_wood_poisson", ".3"}), ortho);
  EXPECT_EQ(all[0].young, 1e10);
  EXPECT_EQ(all[0].density, 700);
  EXPECT_THAT(
      [&] {
        constants(with_box({"-material_young", "1e10"}), ortho);
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("w.veg:9: law ORTHOTROPIC"), HasSubstr("-material_poisson"))));
}

TEST(Materials, OfOptionsAreConvertedToSi) {
  const auto all = materials(
      {"-units", "mm-t-s", "-material_young", "210000", "-material_poisson", ".3", "-material_density", "7.85e-9"});
  EXPECT_NEAR(all[1].young, 210e9, 1);
  EXPECT_NEAR(all[1].density, 7850, 1e-9);
}

std::vector<Constants> of_regions(std::vector<std::string> names, const std::vector<std::string>& more) {
  std::vector<mesh::Region> named;
  for (auto& name : names) named.push_back({std::move(name), std::nullopt});
  return constants(with_box(with(general, more)), named);
}

TEST(Materials, OfRegionsWithBlanksAreNamedWithUnderscores) {
  const auto all = of_regions({"left end", "My_big part", "rest"},
                              {"-material_left_end_young", "2", "-material_my_big_part_young", "3"});
  EXPECT_EQ(all[0].young, 2);
  EXPECT_EQ(all[1].young, 3);
  EXPECT_EQ(all[2].young, 1e6);
  EXPECT_EQ(of_regions({"left end"}, {"-material_left end_young", "2"})[0].young, 2);
}

TEST(Materials, OfTheExactNameAreNoOthers) {
  const auto all = of_regions({"left end", "left_end"}, {"-material_left_end_young", "2"});
  EXPECT_EQ(all[0].young, 1e6);
  EXPECT_EQ(all[1].young, 2);
}

TEST(Materials, MustBeOfOneRegion) {
  const auto refused = [](const std::vector<std::string>& names, const std::vector<std::string>& words,
                          const std::string& first, const std::string& second) {
    EXPECT_THAT([&] { of_regions(names, words); },
                ThrowsMessage<InputError>(AllOf(HasSubstr(first), HasSubstr(second))));
  };
  refused({"a b_c", "a_b c"}, {"-material_a_b_c_young", "2"}, "'a b_c'", "'a_b c'");
  refused({"a b"}, {"-material_a_b_young", "2", "-material_a b_density", "3"}, "-material_a", "one way");
  refused({"a b"}, {"-material_a_c_young", "2"}, "'a_c'", "'a b'");
}

void materials_refuse(const std::vector<std::string>& words, const std::string& first, const std::string& second) {
  EXPECT_THAT([&] { materials(words); }, ThrowsMessage<InputError>(AllOf(HasSubstr(first), HasSubstr(second))));
}

TEST(Materials, MustBeComplete) {
  materials_refuse({}, "'rubber'", "-material_rubber_young");
  materials_refuse({"-material_young", "1e6", "-material_poisson", ".3"}, "'rubber'", "-material_density");
}

TEST(Materials, MustBePossible) {
  materials_refuse(with(general, {"-material_rubber_young", "0"}), "'rubber'", "positive");
  materials_refuse(with(general, {"-material_young", "-1"}), "Young", "positive");
  materials_refuse(with(general, {"-material_poisson", ".5"}), "Poisson", "below 0.5");
  materials_refuse(with(general, {"-material_poisson", "-1"}), "Poisson", "above -1");
  materials_refuse(with(general, {"-material_steel_density", "0"}), "'Steel'", "positive");
}

TEST(Materials, MustBeOfARegionThatExists) {
  EXPECT_THAT(
      [] {
        constants(with_box({}), {{"left end", std::nullopt}});
      },
      ThrowsMessage<InputError>(HasSubstr("-material_left_end_young")));
  materials_refuse(with(general, {"-material_ruber_young", "1"}), "'ruber'", "'rubber'");
}

std::vector<std::string> laws(const std::vector<std::string>& more) {
  std::vector<std::string> names;
  for (const auto& material : region_materials(with_box(with(general, more)), regions))
    names.emplace_back(fem::name(material.law));
  return names;
}

TEST(Materials, HaveALawOfTheirOwn) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(laws({}), (Names{"stvk", "stvk"}));
  EXPECT_EQ(laws({"-material_law", "neo-hookean"}), (Names{"neo-hookean", "neo-hookean"}));
  EXPECT_EQ(laws({"-material_rubber_law", "neo-hookean"}), (Names{"stvk", "neo-hookean"}));
  EXPECT_EQ(laws({"-material_law", "neo-hookean", "-material_steel_law", "stvk"}), (Names{"stvk", "neo-hookean"}));
  EXPECT_THAT(
      [] {
        laws({"-material_law", "neohooke"});
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("-material_law"), HasSubstr("neo-hookean"))));
}

const std::vector<std::string> dense = {"-material_density", "1100"};

std::vector<double> values_of(const std::vector<std::string>& more, const mesh::FileMaterial& of_file = {}) {
  std::vector<double> values;
  const auto materials = region_materials(with_box(with(dense, more)), {{"rubber", of_file}});
  for (const auto& given : fem::parameters(materials.at(0).law)) values.push_back(given.value);
  return values;
}

using Values = std::vector<double>;

TEST(MaterialConstants, MakeTheLawsThatTakeThem) {
  EXPECT_EQ(values_of({"-material_law", "mooney-rivlin", "-material_constants", "1.5e5,4e4,2e-6"}),
            (Values{1.5e5, 4e4, 2e-6}));
  EXPECT_EQ(
      values_of({"-material_law", "ogden", "-material_constants", "1,2,3", "-material_rubber_constants", "4, 5, 6"}),
      (Values{4, 5, 0, 1, 0, 1, 6, 0, 0}));
  EXPECT_EQ(values_of({"-units", "mm-t-s", "-material_law", "yeoh", "-material_constants", "1,2,3,.5"}),
            (Values{1e6, 2e6, 3e6, .5e-6, 0, 0}));
  EXPECT_EQ(values_of({"-material_law", "stvk-orthotropic", "-material_constants", "8,4,2,.3,.25,.2,3,2,1",
                       "-material_axes", "0,1,0,0,0,1"}),
            (Values{8, 4, 2, .3, .25, .2, 3, 2, 1, 0, 1, 0, 0, 0, 1}));
}

TEST(MaterialConstants, OfTheFileStandWhereNoOptionSpeaks) {
  const mesh::FileMaterial rubber{.law = fem::MooneyRivlin{1, 2, 3}};
  EXPECT_EQ(values_of({}, rubber), (Values{1, 2, 3}));
  EXPECT_EQ(values_of({"-material_constants", "4,5,6"}, rubber), (Values{4, 5, 6}));
  EXPECT_EQ(values_of({"-material_law", "stvk", "-material_young", "1e6", "-material_poisson", ".3"}, rubber),
            (Values{1e6, .3}));
  const mesh::FileMaterial isochoric{.young = 1e6, .poisson = .4, .law = fem::IsochoricNeoHookean{1e6, .4}};
  EXPECT_EQ(values_of({"-material_young", "2e6"}, isochoric), (Values{2e6, .4}));
}

void constants_refused(const std::vector<std::string>& more, const std::string& first, const std::string& second,
                       const mesh::FileMaterial& of_file = {}) {
  EXPECT_THAT([&] { values_of(more, of_file); }, ThrowsMessage<InputError>(AllOf(HasSubstr(first), HasSubstr(second))));
}

TEST(MaterialConstants, MustBePossible) {
  constants_refused({"-material_law", "ogden", "-material_constants", "1,2"}, "mu1,alpha1", "2 numbers");
  constants_refused({"-material_law", "ogden"}, "no constants", "-material_rubber_constants");
  constants_refused({"-material_law", "ogden", "-material_constants", "1,2,x"}, "-material_constants", "x");
  constants_refused({"-material_law", "ogden", "-material_constants", "1,2,"}, "-material_constants", "finite");
  constants_refused({"-material_law", "mooney-rivlin", "-material_constants", "1,-2,3"}, "'rubber'", "shear modulus");
  constants_refused({"-material_law", "mooney-rivlin", "-material_constants", "1,2,-3"}, "'rubber'", "positive");
  const std::vector<std::string> wood = {"-material_law", "stvk-orthotropic", "-material_constants",
                                         "8,4,2,.3,.25,.2,3,2,1"};
  constants_refused(with(wood, {"-material_axes", "1,0,0"}), "six numbers", "3 are given");
  constants_refused(with(wood, {"-material_axes", "1,0,0,2,0,0"}), "'rubber'", "angle");
}

// Of two laws' options one would be passed over in silence.
TEST(MaterialConstants, ThatNoLawTakesAreRefused) {
  const std::vector<std::string> hooke = {"-material_young", "1e6", "-material_poisson", ".3"};
  constants_refused(with(hooke, {"-material_constants", "1,2,3"}), "-material_constants does nothing", "stvk");
  constants_refused(with(hooke, {"-material_axes", "1,0,0,0,1,0"}), "-material_axes does nothing", "stvk");
  constants_refused({"-material_young", "1e6"}, "-material_young does nothing", "mooney-rivlin",
                    {.law = fem::MooneyRivlin{1, 2, 3}});
}

}  // namespace
}  // namespace ritz::config
