// *ELASTIC and *HYPERELASTIC, and *ORIENTATION, which says where the axes of an orthotropic material point.
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ritz/readers/inp_model.hpp"

namespace ritz::readers {

namespace {

constexpr std::size_t fields_of_a_line = 8;

/// A set of constants, blank ones as NaN, and where it is written.
struct Row {
  std::vector<double> values;
  Place place;
};

void accept_all(const Row&) {}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// The `count` constants that stand in front of each set of data lines, which may go on with a temperature and fields.
/// Nothing where they differ from set to set. Calls check(row) for each.
template <class Check>
std::optional<Row> constants_of(Deck& deck, const Keyword& keyword, std::size_t count, Check check) {
  std::optional<Row> first;
  bool depends = false;
  while (auto line = deck.next_data()) {
    Row row{{}, line->place};
    for (std::size_t left = count;;) {
      const auto parts = fields(*line);
      for (std::size_t i = 0; i < std::min(left, fields_of_a_line); ++i) {
        auto cursor = i < parts.size() ? deck.cursor(parts[i]) : deck.cursor({line->place, {}});
        row.values.push_back(cursor.line_ends() ? std::nan("") : cursor.real("a constant of the material"));
        cursor.end_line();
      }
      left -= std::min(left, fields_of_a_line);
      if (left == 0) break;
      line = deck.next_data();
      if (!line)
        deck.fail(row.place, "*" + keyword.title + " has " + std::to_string(count) + " constants, on two lines");
    }
    check(row);
    depends = depends || (first && !same(first->values, row.values));
    if (!first) first = row;
  }
  if (!first) deck.fail(keyword.place, "*" + keyword.title + " has no data line");
  return depends ? std::nullopt : first;
}

/// Young's modulus and Poisson's ratio of the shear modulus 2 C10 and the bulk modulus 2/D.
fem::IsochoricNeoHookean neo_hookean(double c10, double d) {
  const double shear = 2 * c10, bulk = 2 / d;
  return {9 * bulk * shear / (3 * bulk + shear), (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear))};
}

/// A form of *HYPERELASTIC: how many constants a line has, which of them is D₁, and the law that they make.
struct Form {
  std::size_t count, volume;
  fem::AnyLaw (*law)(const std::vector<double>& c);
};

Form neo_hookean_form() {
  return {2, 1, [](const std::vector<double>& c) -> fem::AnyLaw { return neo_hookean(c[0], c[1]); }};
}

Form mooney_rivlin_form() {
  return {3, 2, [](const std::vector<double>& c) -> fem::AnyLaw { return fem::MooneyRivlin{c[0], c[1], c[2]}; }};
}

Form yeoh_form() {
  return {6, 3,
          [](const std::vector<double>& c) -> fem::AnyLaw { return fem::Yeoh{c[0], c[1], c[2], c[3], c[4], c[5]}; }};
}

std::optional<Form> form_of(const Keyword& keyword) {
  const std::string N = keyword.value("N").value_or("1");
  const bool other = keyword.has("VANDERWAALS") || keyword.has("MARLOW") || keyword.has("USER") ||
                     keyword.has("VALANIS-LANDEL") || keyword.has("TESTDATAINPUT");
  if (other) return std::nullopt;
  if (keyword.has("NEOHOOKE") || keyword.has("NEOHOOKEAN")) return neo_hookean_form();
  if (keyword.has("MOONEY-RIVLIN")) return mooney_rivlin_form();
  if (keyword.has("YEOH")) return yeoh_form();
  if (keyword.has("ARRUDA-BOYCE"))
    return Form{3, 2, [](const std::vector<double>& c) -> fem::AnyLaw { return fem::ArrudaBoyce{c[0], c[1], c[2]}; }};
  if (keyword.has("OGDEN")) {
    if (N == "1")
      return Form{3, 2, [](const std::vector<double>& c) -> fem::AnyLaw {
                    return fem::Ogden{.mu1 = c[0], .alpha1 = c[1], .d1 = c[2]};
                  }};
    if (N == "2")
      return Form{6, 4, [](const std::vector<double>& c) -> fem::AnyLaw {
                    return fem::Ogden{.mu1 = c[0], .alpha1 = c[1], .mu2 = c[2], .alpha2 = c[3], .d1 = c[4], .d2 = c[5]};
                  }};
    if (N == "3")
      return Form{9, 6, [](const std::vector<double>& c) -> fem::AnyLaw {
                    return fem::Ogden{c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]};
                  }};
    return std::nullopt;
  }
  if (keyword.has("REDUCEDPOLYNOMIAL")) {
    if (N == "1") return neo_hookean_form();
    if (N == "2")
      return Form{4, 2, [](const std::vector<double>& c) -> fem::AnyLaw {
                    return fem::Yeoh{c[0], c[1], 0, c[2], c[3]};
                  }};
    if (N == "3") return yeoh_form();
    return std::nullopt;
  }
  if (N != "1") return std::nullopt;  // the default is POLYNOMIAL
  return mooney_rivlin_form();
}

InpUnread dependent_law(const Keyword& keyword) {
  return {"*" + keyword.title + " with constants that depend on temperature or fields is not supported", keyword.place};
}

/// The nine constants D1111, D1122, D2222, D1133, D2233, D3333, D1212, D1313, D2323 of a stiffness as engineering ones.
std::vector<double> engineering_constants(const Deck& deck, Place place, const std::vector<double>& d) {
  Eigen::Matrix3d stiffness;
  stiffness << d[0], d[1], d[3], d[1], d[2], d[4], d[3], d[4], d[5];
  if (stiffness.llt().info() != Eigen::Success)
    deck.fail(place, "the constants of *ELASTIC cannot be: the stiffness at rest is not positive");
  const Eigen::Matrix3d S = stiffness.inverse();
  return {1 / S(0, 0), 1 / S(1, 1), 1 / S(2, 2), -S(0, 1) / S(0, 0), -S(0, 2) / S(0, 0), -S(1, 2) / S(1, 1),
          d[6],        d[7],        d[8]};
}

void read_isotropic(Deck& deck, const Keyword& keyword, InpMaterial& material) {
  const auto check = [&](const Row& row) {
    if (std::isnan(row.values[1])) deck.fail(row.place, "*ELASTIC has no Poisson's ratio here");
    checked(deck.sources(), row.place, {.young = row.values[0], .poisson = row.values[1], .density = {}});
  };
  const auto row = constants_of(deck, keyword, 2, check);
  if (!row) {
    material.law = dependent_law(keyword);
    return;
  }
  material.young = row->values[0];
  material.poisson = row->values[1];
}

void read_orthotropic(Deck& deck, const Keyword& keyword, InpMaterial& material, bool by_stiffness) {
  const auto row = constants_of(deck, keyword, 9, accept_all);
  if (!row) {
    material.law = dependent_law(keyword);
    return;
  }
  if (std::any_of(row->values.begin(), row->values.end(), [](double v) { return std::isnan(v); }))
    deck.fail(row->place, "*ELASTIC of this type has nine constants, eight on the first line and one on the second");
  const auto law = fem::OrthotropicStVK::of_constants(
      by_stiffness ? engineering_constants(deck, row->place, row->values) : row->values);
  material.known_law = possible(deck.sources(), row->place, *law);
}

}  // namespace

void read_inp_elastic(Deck& deck, const Keyword& keyword, InpModel& model) {
  auto& material = current_material(deck, keyword, model);
  const auto type = upper(keyword.value("TYPE").value_or("ISOTROPIC"));
  if (type.starts_with("ISO")) read_isotropic(deck, keyword, material);
  else if (type.starts_with("ORTHO")) read_orthotropic(deck, keyword, material, true);
  else if (type.starts_with("ENGINEERING")) read_orthotropic(deck, keyword, material, false);
  else
    material.law = {"elasticity of type " + type + " is not supported, only ISOTROPIC, ORTHO and ENGINEERING CONSTANTS",
                    keyword.place};
}

void read_inp_hyperelastic(Deck& deck, const Keyword& keyword, InpModel& model) {
  auto& material = current_material(deck, keyword, model);
  const auto form = form_of(keyword);
  if (!form) {
    material.law = {
        "this form of *HYPERELASTIC is not supported; ritz knows NEO HOOKE, MOONEY-RIVLIN, YEOH, ARRUDA-BOYCE, "
        "OGDEN and REDUCED POLYNOMIAL with N up to 3, and POLYNOMIAL with N=1, by their constants",
        keyword.place};
    return;
  }
  auto row = constants_of(deck, keyword, form->count, accept_all);
  if (!row) {
    material.law = dependent_law(keyword);
    return;
  }
  for (double& value : row->values)  // a constant that is left out is zero
    if (std::isnan(value)) value = 0;
  if (!(row->values[form->volume] > 0))
    deck.fail(
        row->place,
        "*HYPERELASTIC without a positive D1 is an incompressible material, which ritz cannot do; the bulk modulus is "
        "2/D1: give a D1 that makes it a thousand times the shear modulus, say");
  material.known_law = possible(deck.sources(), row->place, form->law(row->values));
}

void read_inp_orientation(Deck& deck, const Keyword& keyword, InpModel& model) {
  const auto name = full_name(model.scope, upper(needed(deck, keyword, "NAME")));
  auto& orientation = model.orientations[name];
  const auto system = upper(keyword.value("SYSTEM").value_or("RECTANGULAR"));
  const auto definition = upper(keyword.value("DEFINITION").value_or("COORDINATES"));
  if (!system.starts_with("R") || definition != "COORDINATES") {
    orientation.unread = {"*ORIENTATION is supported with SYSTEM=RECTANGULAR and DEFINITION=COORDINATES only",
                          keyword.place};
    return;
  }
  const auto line = deck.next_data();
  if (!line) deck.fail(keyword.place, "*ORIENTATION has no data line");
  std::array<double, 9> given{};
  const auto parts = fields(*line);
  for (std::size_t i = 0; i < std::min(parts.size(), given.size()); ++i) {
    auto cursor = deck.cursor(parts[i]);
    if (!cursor.line_ends()) given[i] = cursor.real("a coordinate");
    cursor.end_line();
  }
  const auto point = [&](std::size_t i) { return placed(model.scope, {given[i], given[i + 1], given[i + 2]}); };
  const auto a = point(0), b = point(3), origin = point(6);
  for (std::size_t i = 0; i < 3; ++i) {
    orientation.axes[i] = a[i] - origin[i];
    orientation.axes[3 + i] = b[i] - origin[i];
  }
  if (const auto turn = deck.next_data()) {
    const auto words = fields(*turn);
    auto cursor = deck.cursor(words.back());
    if (words.size() > 1 && cursor.real("an angle") != 0)
      orientation.unread = {"*ORIENTATION with an additional rotation is not supported", turn->place};
  }
}

}  // namespace ritz::readers
