# The Python module, where pybind11 is. It is built for /usr/bin/python3 unless Python3_EXECUTABLE says otherwise.
#
# ritz_find_python(RESULT): whether Python's headers and pybind11 are here, and no sanitizer is asked for: an interpreter
# without one could not load what has one.
function(ritz_find_python result)
  set(${result} OFF PARENT_SCOPE)
  if(RITZ_SANITIZE)
    return()
  endif()
  if(NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python3_EXECUTABLE /usr/bin/python3)
  endif()
  find_package(Python3 3.9 QUIET COMPONENTS Interpreter Development.Module)
  if(Python3_FOUND)
    find_package(pybind11 2.10 CONFIG QUIET)
  endif()
  if(NOT pybind11_FOUND)
    message(STATUS "No Python module: Python's headers or pybind11 are not here (packages python3-dev, pybind11-dev)")
    return()
  endif()
  set(RITZ_PYTHON_DIR "lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/dist-packages" CACHE STRING
    "Where the Python module is installed, below the prefix")
  set(${result} ON PARENT_SCOPE)
endfunction()

# ritz_python_module(NAME LAYER): the module NAME, which src/LAYER/NAME_module.cpp defines, and its type stubs NAME.pyi, in
# the folder `python` of the build.
function(ritz_python_module name layer)
  set(folder "${PROJECT_BINARY_DIR}/python")
  set(sources "${PROJECT_SOURCE_DIR}/src/${layer}")
  pybind11_add_module(${name}_module MODULE NO_EXTRAS "${sources}/${name}_module.cpp")
  target_link_libraries(${name}_module PRIVATE ritz_${layer} ritz_settings)
  foreach(target ${name}_module ritz_${layer})
    # pybind11's types are hidden, and so must be what holds them. What is fast is in the layers below.
    set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden DISABLE_PRECOMPILE_HEADERS ON)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endforeach()
  set_target_properties(${name}_module PROPERTIES OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY "${folder}")
  configure_file("${sources}/${name}.pyi" "${folder}/${name}.pyi" COPYONLY)
  install(TARGETS ${name}_module LIBRARY DESTINATION "${RITZ_PYTHON_DIR}")
  install(FILES "${sources}/${name}.pyi" DESTINATION "${RITZ_PYTHON_DIR}")
endfunction()
