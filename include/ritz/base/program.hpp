// What all programs of ritz have in common.
#pragma once

namespace ritz {

/// The version of ritz, as CMakeLists.txt states it.
inline constexpr const char* version = "0.1.0";

/// How much a program prints: everything, or warnings and errors alone.
enum class Voice : unsigned char { normal, quiet };

}  // namespace ritz
