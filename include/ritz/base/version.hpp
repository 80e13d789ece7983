// The version of ritz, as CMakeLists.txt states it.
#pragma once

namespace ritz {

inline constexpr const char* version = "0.1.0";

}  // namespace ritz
