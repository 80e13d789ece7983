#include "ritz/fem/material.hpp"

#include <algorithm>
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

 private:
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
