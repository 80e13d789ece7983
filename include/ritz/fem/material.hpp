// The materials of a body: any of the laws, with a density.
//
// A new law is one file in laws/ and its name in the list below.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "ritz/fem/laws/neo_hookean.hpp"
#include "ritz/fem/laws/stvk.hpp"

namespace ritz::fem {

using AnyLaw = std::variant<StVK, NeoHookean>;

/// Where nothing is said.
inline constexpr const char* default_law = StVK::name;

struct Material {
  AnyLaw law;
  double density;  ///< kg/m³, > 0

  ElasticConstants at_rest() const {
    return std::visit([](const auto& any) { return any.at_rest(); }, law);
  }
};

/// The responses and moduli of a material at a batch of points, given their displacement gradients: what elements ask,
/// so that elements and laws are compiled apart. The spans are of one length.
void respond(const Material& material, std::span<const Matrix<3, 3>> gradients, std::span<Response> responses);
void linearise(const Material& material, std::span<const Matrix<3, 3>> gradients, std::span<Moduli> moduli);

/// One a region of the mesh.
using Materials = std::vector<Material>;

/// The names of all laws, as users write them.
std::vector<std::string_view> law_names();

inline const char* name(const AnyLaw& law) {
  return std::visit([](const auto& any) { return any.name; }, law);
}

/// The law of that name, made of what `value` says of each of its parameters; nothing where there is no such law.
std::optional<AnyLaw> make_law(std::string_view name, const std::function<double(const Parameter&)>& value);

struct ParameterValue {
  Parameter parameter;
  double value;

  /// Whether it is a finite number in the parameter's interval.
  bool possible() const { return value > parameter.above && value < parameter.below; }
};

/// What a law was told.
std::vector<ParameterValue> parameters(const AnyLaw& law);

/// The degree of the force of all of them as a polynomial in the displacement; nothing where one has none.
std::optional<int> force_degree(const Materials& materials);

/// All laws as L, one a region; nothing where one is another.
template <Law L>
std::optional<std::vector<L>> all_of(const Materials& materials) {
  std::vector<L> laws;
  for (const auto& material : materials) {
    const L* law = std::get_if<L>(&material.law);
    if (!law) return std::nullopt;
    laws.push_back(*law);
  }
  return laws;
}

}  // namespace ritz::fem
