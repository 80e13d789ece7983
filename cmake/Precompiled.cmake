# Headers of others that most sources read, compiled once: without, a third of the build is spent reading them.
# Every source still names what it uses. Not beside ccache, which then finds nothing again.
if(CCACHE)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms inside std::string, as in Settings: precompiled headers no longer count as the system's.
  target_compile_options(ritz_settings INTERFACE -Wno-stringop-overflow -Wno-stringop-overread
    -Wno-array-bounds)
endif()

# ritz_precompiled(NAME LIBRARIES targets... HEADERS headers...): the target ritz_NAME, whose headers others reuse.
function(ritz_precompiled name)
  cmake_parse_arguments(P "" "" "LIBRARIES;HEADERS;OPTIONS" ${ARGN})
  set(empty "${PROJECT_BINARY_DIR}/ritz_${name}.cpp")
  file(GENERATE OUTPUT "${empty}" CONTENT "")
  add_library(ritz_${name} OBJECT "${empty}")
  target_link_libraries(ritz_${name} PRIVATE ritz_settings ${P_LIBRARIES})
  target_compile_options(ritz_${name} PRIVATE ${P_OPTIONS})
  target_precompile_headers(ritz_${name} PRIVATE ${P_HEADERS})
endfunction()
