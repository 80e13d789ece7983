# A layer is a folder, a namespace and a CMake target at once. Its headers are reached as "ritz/LAYER/x.hpp"
# through an include path of its own, which only the layers named after USES can see: a forbidden include
# finds no file.
#
#   ritz_layer(NAME [INSTALLED] [FOLDER F] [USES layers...] [LIBRARIES targets...])
#
# INSTALLED: the headers live in include/ritz/F and are installed; else they stand beside the sources in src/F.
# FOLDER: where the sources are, when one folder is compiled into two layers (format: serial and MPI HDF5).
function(ritz_layer name)
  cmake_parse_arguments(L "INSTALLED" "FOLDER" "USES;LIBRARIES" ${ARGN})
  set(folder ${name})
  if(L_FOLDER)
    set(folder ${L_FOLDER})
  endif()

  set(headers "${PROJECT_SOURCE_DIR}/src/${folder}")
  if(EXISTS "${PROJECT_SOURCE_DIR}/include/ritz/${folder}")
    set(headers "${PROJECT_SOURCE_DIR}/include/ritz/${folder}")
  endif()
  set(root "${PROJECT_BINARY_DIR}/layers/${folder}")
  file(MAKE_DIRECTORY "${root}/ritz")
  file(CREATE_LINK "${headers}" "${root}/ritz/${folder}" SYMBOLIC)

  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${folder}/*.cpp"
    "${PROJECT_SOURCE_DIR}/src/${folder}/*/*.cpp")
  list(FILTER sources EXCLUDE REGEX "_(main|module)\\.cpp$")
  set(target ritz_${name})
  if(sources)
    add_library(${target} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:ritz_settings>)
    if("fem" IN_LIST L_USES OR "Eigen3::Eigen" IN_LIST L_LIBRARIES)
      target_precompile_headers(${target} REUSE_FROM ritz_dense)
    elseif("model" IN_LIST L_USES AND NOT RITZ_SANITIZE_PLAIN)
      target_precompile_headers(${target} REUSE_FROM ritz_dense)  # with other options they are other headers
    else()
      target_compile_options(${target} PRIVATE ${RITZ_SANITIZE_PLAIN})
    endif()
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(ritz::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} ${scope} cxx_std_20)
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${root}>)
  list(TRANSFORM L_USES PREPEND ritz_)
  target_link_libraries(${target} ${scope} ${L_USES} ${L_LIBRARIES})
  set_property(GLOBAL APPEND PROPERTY RITZ_LAYERS ${name})
endfunction()

# ritz_program(NAME LAYER): the executable whose main is src/LAYER/NAME_main.cpp ('-' written '_').
function(ritz_program name layer)
  string(REPLACE "-" "_" stem ${name})
  add_executable(${name} "${PROJECT_SOURCE_DIR}/src/${layer}/${stem}_main.cpp")
  target_link_libraries(${name} PRIVATE ritz_${layer} ritz_settings)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)  # a main reads options and calls the layer
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()
