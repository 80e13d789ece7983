#include "ritz/mesh/read_inp_types.hpp"

#include <algorithm>

namespace ritz::mesh {
namespace {

struct Known {
  std::string_view name;
  Shape shape;
};

constexpr Known lower[] = {
    {"CPS3", Shape::tri3},   {"CPE3", Shape::tri3},    {"CPE3H", Shape::tri3},    {"CAX3", Shape::tri3},
    {"S3", Shape::tri3},     {"S3R", Shape::tri3},     {"S3RS", Shape::tri3},     {"STRI3", Shape::tri3},
    {"M3D3", Shape::tri3},   {"SFM3D3", Shape::tri3},  {"R3D3", Shape::tri3},     {"CPS6", Shape::tri6},
    {"CPE6", Shape::tri6},   {"CAX6", Shape::tri6},    {"S6", Shape::tri6},       {"STRI65", Shape::tri6},
    {"M3D6", Shape::tri6},   {"SFM3D6", Shape::tri6},  {"CPS4", Shape::quad4},    {"CPE4", Shape::quad4},
    {"CAX4", Shape::quad4},  {"S4", Shape::quad4},     {"CPS4R", Shape::quad4},   {"CPE4R", Shape::quad4},
    {"CAX4R", Shape::quad4}, {"CPS4I", Shape::quad4},  {"CPE4I", Shape::quad4},   {"CPE4H", Shape::quad4},
    {"S4R", Shape::quad4},   {"S4RS", Shape::quad4},   {"S4R5", Shape::quad4},    {"M3D4", Shape::quad4},
    {"M3D4R", Shape::quad4}, {"SFM3D4", Shape::quad4}, {"SFM3D4R", Shape::quad4}, {"R3D4", Shape::quad4},
    {"T3D2", Shape::line2},  {"B31", Shape::line2},    {"B31R", Shape::line2},    {"T2D2", Shape::line2},
    {"B21", Shape::line2},   {"B33", Shape::line2},    {"T3D3", Shape::line3},    {"B32", Shape::line3},
    {"B32R", Shape::line3},  {"T2D3", Shape::line3}};

struct Suffix {
  std::string_view name;
  std::string_view formulation;
};

// T adds temperatures to the same displacements.
constexpr Suffix of_tetrahedra[] = {{"T", ""},
                                    {"H", "hybrid"},
                                    {"HT", "hybrid"},
                                    {"M", "modified"},
                                    {"MT", "modified"},
                                    {"MH", "modified and hybrid"},
                                    {"MHT", "modified and hybrid"},
                                    {"HS", "hybrid, improved stresses"},
                                    {"I", "improved stresses"}};

constexpr Suffix of_hexahedra[] = {{"T", ""},
                                   {"R", "reduced integration"},
                                   {"RT", "reduced integration"},
                                   {"RH", "reduced integration, hybrid"},
                                   {"RHT", "reduced integration, hybrid"},
                                   {"H", "hybrid"},
                                   {"HT", "hybrid"},
                                   {"I", "incompatible modes"},
                                   {"IH", "incompatible modes, hybrid"},
                                   {"S", "improved stresses"},
                                   {"HS", "hybrid, improved stresses"}};

struct Solid {
  std::string_view name;
  Shape shape;
  InpReading other;  // formulations
  std::span<const Suffix> suffixes;
};

// A quadratic tetrahedron bends well in any formulation; a hexahedron with reduced integration is another thing.
constexpr Solid solids[] = {{"C3D4", Shape::tet4, InpReading::noted, of_tetrahedra},
                            {"C3D10", Shape::tet10, InpReading::noted, of_tetrahedra},
                            {"C3D8", Shape::hex8, InpReading::on_your_word, of_hexahedra}};

struct Family {
  std::string_view begin;
  std::string_view keyword;
};

constexpr Family families[] = {{"MASS", "MASS"},     {"ROTARYI", "ROTARYINERTIA"},
                               {"SPRING", "SPRING"}, {"DASHPOT", "DASHPOT"},
                               {"GAP", "GAP"},       {"CONN", "CONNECTORSECTION"}};

}  // namespace

InpType inp_type(const std::string& name) {
  for (const auto& solid : solids) {
    if (!name.starts_with(solid.name)) continue;
    const std::string plain(solid.name), end = name.substr(solid.name.size());
    if (end.empty()) return {InpReading::same, solid.shape, plain, {}};
    for (const auto& suffix : solid.suffixes)
      if (suffix.name == end)
        return {suffix.formulation.empty() ? InpReading::same : solid.other, solid.shape, plain,
                std::string(suffix.formulation)};
  }
  for (const auto& type : lower)
    if (type.name == name) return {InpReading::same, type.shape, name, {}};
  return {InpReading::none, Shape::point, {}, {}};
}

std::vector<std::string> words_of_type(const std::string& name) {
  for (const auto& [begin, keyword] : families)
    if (name.starts_with(begin)) return {std::string(keyword), name};
  return {name};
}

}  // namespace ritz::mesh
