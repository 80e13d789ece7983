# Language, build type and warnings for every target of ritz.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 20)  # where a build is one of units: most layers are one, for each reads Eigen anew
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug, RelWithDebInfo" FORCE)
endif()
# GCC collects its garbage early and often, which costs a tenth to a fifth of a unit's time. It waits until 1.5 GB.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-heapsize=1500000)
endif()
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE}")
endif()

add_library(ritz_settings INTERFACE)
target_compile_options(ritz_settings INTERFACE -Wall -Wextra $<$<BOOL:${RITZ_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns of overlapping copies inside std::string's operator+ where there are none (GCC bug 105651).
  target_compile_options(ritz_settings INTERFACE -Wno-restrict)
endif()
if(RITZ_SANITIZE)
  # GCC documents false alarms of this warning in instrumented code; the build without instruments has it.
  target_compile_options(ritz_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_compile_options(${RITZ_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(${RITZ_SANITIZE})
endif()

# No search path in the programs: the one that CMake builds in ends in an empty entry, which the loader takes for the
# current folder, and a library that somebody put there would be loaded.
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)
