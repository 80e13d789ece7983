#include "ritz/fem/material.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <utility>

namespace ritz::fem {
namespace {

using Value = std::function<double(const Parameter&)>;

/// The names of a variant's alternatives, and how to make one of them.
template <class Variant>
struct Laws;

template <Law... L>
struct Laws<std::variant<L...>> {
  static std::vector<std::string_view> names() { return {L::name...}; }

  static std::optional<AnyLaw> make(std::string_view name, const Value& value) {
    std::optional<AnyLaw> law;
    ((name == L::name ? void(law = make_one<L>(value)) : void()), ...);
    return law;
  }

  static std::optional<AnyLaw> of_constants(std::string_view name, std::span<const double> given) {
    std::optional<AnyLaw> law;
    ((name == L::name ? void(law = of_list<L>(given)) : void()), ...);
    return law;
  }

  static std::optional<std::string_view> constants(std::string_view name) {
    std::optional<std::string_view> words;
    ((name == L::name ? void(words = list_of<L>()) : void()), ...);
    return words;
  }

 private:
  template <class One>
  static std::optional<AnyLaw> of_list(std::span<const double> given) {
    if constexpr (LawOfConstants<One>) {
      if (const auto law = One::of_constants(given)) return AnyLaw{*law};
    }
    return std::nullopt;
  }

  template <class One>
  static std::optional<std::string_view> list_of() {
    if constexpr (LawOfConstants<One>) return One::constants;
    else return std::nullopt;
  }

  template <class One>
  static One make_one(const Value& value) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) { return One{value(One::parameters[i])...}; }
    (std::make_index_sequence<One::parameters.size()>());
  }
};

template <class L>
std::optional<int> degree(const L&) {
  if constexpr (PolynomialLaw<L>) return L::force_degree;
  else return std::nullopt;
}

ParameterValue must_be_positive(const char* words, const char* units, double value) {
  return {{words, words, units, 0, std::numeric_limits<double>::infinity()}, value};
}

template <class L>
std::optional<ParameterValue> unstable(const L&) {
  return std::nullopt;
}

std::optional<ParameterValue> unstable(const Ogden& law) {
  if (law.alpha1 == 0 || (law.mu2 != 0 && law.alpha2 == 0) || (law.mu3 != 0 && law.alpha3 == 0))
    return must_be_positive("size of an exponent", "1", 0);
  return std::nullopt;
}

std::optional<ParameterValue> unstable(const OrthotropicStVK& law) {
  if (!(law.angle_of_axes() > 1e-6)) return must_be_positive("angle between the axes", "1", 0);
  return std::nullopt;
}

}  // namespace

void respond(const Material& material, std::span<const Matrix<3, 3>> gradients, std::span<Response> responses) {
  std::visit(
      [&](const auto& law) {
        for (std::size_t q = 0; q < gradients.size(); ++q) responses[q] = law.response(gradients[q]);
      },
      material.law);
}

void linearise(const Material& material, std::span<const Matrix<3, 3>> gradients, std::span<Moduli> moduli) {
  std::visit(
      [&](const auto& law) {
        for (std::size_t q = 0; q < gradients.size(); ++q) moduli[q] = law.moduli(gradients[q]);
      },
      material.law);
}

std::vector<std::string_view> law_names() { return Laws<AnyLaw>::names(); }

std::optional<AnyLaw> make_law(std::string_view name, const Value& value) { return Laws<AnyLaw>::make(name, value); }

std::vector<ParameterValue> parameters(const AnyLaw& law) {
  return std::visit(
      []<class L>(const L& any) {
        std::vector<ParameterValue> all;
        const auto values = any.values();
        for (std::size_t i = 0; i < values.size(); ++i) all.push_back({L::parameters[i], values[i]});
        return all;
      },
      law);
}

std::optional<ParameterValue> unstable_at_rest(const AnyLaw& law) {
  if (const auto found = std::visit([](const auto& any) { return unstable(any); }, law)) return found;
  const auto rest = std::visit([](const auto& any) { return any.at_rest(); }, law);
  if (!rest.moduli) {
    if (!(rest.mu > 0)) return must_be_positive("shear modulus at rest", "Pa", rest.mu);
    return std::nullopt;
  }
  const Vector<6> eigenvalues =
      Eigen::SelfAdjointEigenSolver<Matrix<6, 6>>(*rest.moduli, Eigen::EigenvaluesOnly).eigenvalues();
  if (!(eigenvalues[0] > 1e-13 * eigenvalues[5]))
    return must_be_positive("smallest stiffness at rest", "Pa", eigenvalues[0]);
  return std::nullopt;
}

std::optional<ParameterValue> impossible(const AnyLaw& law) {
  for (const auto& given : parameters(law))
    if (!given.possible()) return given;
  return unstable_at_rest(law);
}

AnyLaw to_si(const AnyLaw& law, double pressure) {
  const auto values = parameters(law);
  std::size_t next = 0;
  return *make_law(name(law), [&](const Parameter& parameter) {
    const std::string_view units = parameter.units;
    const double value = values[next++].value;
    return units == "Pa" ? value * pressure : units == "1/Pa" ? value / pressure : value;
  });
}

std::optional<AnyLaw> law_of_constants(std::string_view name, std::span<const double> constants) {
  return Laws<AnyLaw>::of_constants(name, constants);
}

std::optional<std::string_view> constants_of(std::string_view name) { return Laws<AnyLaw>::constants(name); }

std::optional<int> force_degree(const Materials& materials) {
  int highest = 1;
  for (const auto& material : materials) {
    const auto of_law = std::visit([](const auto& law) { return degree(law); }, material.law);
    if (!of_law) return std::nullopt;
    highest = std::max(highest, *of_law);
  }
  return highest;
}

}  // namespace ritz::fem
