// The materials of a body: each is one of the laws, with a density.
//
// A new law is a header and a source in laws/, and its name in the list below.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "ritz/fem/laws/isochoric.hpp"
#include "ritz/fem/laws/neo_hookean.hpp"
#include "ritz/fem/laws/orthotropic.hpp"
#include "ritz/fem/laws/stretches.hpp"
#include "ritz/fem/laws/stvk.hpp"

namespace ritz::fem {

using AnyLaw = std::variant<StVK, NeoHookean, IsochoricNeoHookean, MooneyRivlin, Yeoh, ArrudaBoyce, Ogden, Hencky,
                            Corotational, OrthotropicStVK>;

/// The law of a material for which none is given.
inline constexpr const char* default_law = StVK::name;

struct Material {
  AnyLaw law;
  double density;  ///< kg/m³, > 0

  ElasticConstants at_rest() const {
    return std::visit([](const auto& any) { return any.at_rest(); }, law);
  }
};

/// Compute the responses and the moduli of a material at a batch of points, from the displacement gradients there.
/// Elements call these, so that elements and laws are compiled separately. The spans have the same length.
void respond(const Material& material, std::span<const Matrix<3, 3>> gradients, std::span<Response> responses);
void linearise(const Material& material, std::span<const Matrix<3, 3>> gradients, std::span<Moduli> moduli);

/// The materials of a mesh, one for each region.
using Materials = std::vector<Material>;

/// The names of all laws, as users write them.
std::vector<std::string_view> law_names();

/// The name of a law, as users write it.
inline const char* name(const AnyLaw& law) {
  return std::visit([](const auto& any) { return any.name; }, law);
}

/// The law called `name`, with the values that `value` returns for its parameters; nothing if there is no such law. The
/// values are not checked (see ParameterValue::possible).
std::optional<AnyLaw> make_law(std::string_view name, const std::function<double(const Parameter&)>& value);

struct ParameterValue {
  Parameter parameter;
  double value;

  /// Whether `value` is finite and lies in the parameter's interval.
  bool possible() const { return value > parameter.above && value < parameter.below; }
};

/// The parameters of a law and their values.
std::vector<ParameterValue> parameters(const AnyLaw& law);

/// What of a law must be positive at rest and is not, although each of its parameters is possible: the shear modulus,
/// the stiffness, an exponent, the angle between two axes. Nothing if there is no such.
std::optional<ParameterValue> unstable_at_rest(const AnyLaw& law);

/// The first parameter that is not possible, or else what unstable_at_rest returns; nothing if the law can be.
std::optional<ParameterValue> impossible(const AnyLaw& law);

/// The law of the constants that a user listed; nothing if it takes no list, or another number of them.
std::optional<AnyLaw> law_of_constants(std::string_view name, std::span<const double> constants);

/// What the constants of a law are called, in their order; nothing if the law is made of its parameters one by one.
std::optional<std::string_view> constants_of(std::string_view name);

/// The law of constants in units of which one of stress is `pressure` Pa: the same law in SI.
AnyLaw to_si(const AnyLaw& law, double pressure);

/// The highest degree of the materials' forces as polynomials in the displacement (at least 1); nothing if one is not a
/// polynomial.
std::optional<int> force_degree(const Materials& materials);

}  // namespace ritz::fem
