// What all programs of ritz have in common.
#pragma once

namespace ritz {

/// The version of ritz, as CMakeLists.txt states it.
inline constexpr const char* version = "0.1.0";

/// How much a program prints: what its user asked for; warnings and errors alone; or details of the numerics too.
enum class Voice : unsigned char { normal, quiet, verbose };

}  // namespace ritz
