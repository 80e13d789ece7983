// The words that stand for enumerators in files.
#pragma once
#include <string_view>

#include "ritz/format/motion.hpp"
#include "ritz/model/model.hpp"

namespace ritz::format {

std::string_view name(model::Rows rows);            ///< all, surface
std::string_view name(model::ModeKind kind);        ///< rigid, flexible
std::string_view name(model::Certified certified);  ///< no, probabilistic, inertia-f32, inertia
std::string_view name(model::Integrand integrand);  ///< energy, beyond-polynomial
std::string_view name(StateKind kind);              ///< at_rest, moving

/// Writes the enumerator called `text` to the second argument; false when there is none.
bool parse(std::string_view text, model::Rows& rows);
bool parse(std::string_view text, model::ModeKind& kind);
bool parse(std::string_view text, model::Certified& certified);
bool parse(std::string_view text, model::Integrand& integrand);
bool parse(std::string_view text, StateKind& kind);

}  // namespace ritz::format
