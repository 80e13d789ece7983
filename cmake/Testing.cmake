# ritz_add_test(NAME SOURCES a.cpp ... LINKS layers... [RANKS 1 2 3] [SHARED FILTER] [LONG FILTER] [TIMEOUT s] [THOROUGH])
# A GoogleTest executable test_NAME. With RANKS it is run under mpirun once for each number of ranks, with a main that
# starts PETSc and fails on every rank when one rank fails; without, it is a serial program.
# SHARED: a GoogleTest filter of what reads ../shared; it is a test of its own, NAME_shared, which is skipped where that is
# absent. "*": all of it.
# LONG: a filter of what takes long; it is a test of its own, NAME_long, with the label "thorough".
# Tests with the label "thorough" are left out of a quick run: whatever takes long, and ranks other than 2. THOROUGH gives
# it to all runs. The target `quick` builds what the other tests need.
find_package(GTest REQUIRED)
include(CTest)
add_custom_target(quick)
# What is tested is optimised; the tests themselves are compiled in a third of the time with less of it, and those that
# run under a sanitizer in half the time without.
set(RITZ_TEST_OPTIONS $<$<CONFIG:Release>:-O1>)
if(RITZ_SANITIZE)
  set(RITZ_TEST_OPTIONS -O0 -g0)
endif()
ritz_precompiled(tests LIBRARIES Eigen3::Eigen GTest::gtest GTest::gmock OPTIONS ${RITZ_TEST_OPTIONS} -fPIE
  HEADERS <Eigen/Dense> <gmock/gmock.h> <gtest/gtest.h>)
# Tests are executables, whose code is position independent in another way than a library's.
set_target_properties(ritz_tests PROPERTIES POSITION_INDEPENDENT_CODE OFF)

# ritz_test_settings(TARGET): how the code of tests is compiled. In a unity build it is one unit a target, for the
# templates of Eigen and GoogleTest are compiled anew in each unit.
function(ritz_test_settings target)
  target_link_libraries(${target} PRIVATE ritz_settings GTest::gtest GTest::gmock)
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  target_compile_options(${target} PRIVATE ${RITZ_TEST_OPTIONS})
  target_precompile_headers(${target} REUSE_FROM ritz_tests)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE 0)
endfunction()

# ritz_test_library(NAME SOURCES a.cpp ... LINKS targets...): ritz_NAME, what several tests share, compiled once.
function(ritz_test_library name)
  cmake_parse_arguments(L "" "" "SOURCES;LINKS" ${ARGN})
  add_library(ritz_${name} STATIC ${L_SOURCES})
  ritz_test_settings(ritz_${name})
  target_link_libraries(ritz_${name} PUBLIC ${L_LINKS})
  target_compile_options(ritz_${name} PRIVATE -fPIE)
  set_target_properties(ritz_${name} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
endfunction()

ritz_test_library(test_dense SOURCES "${PROJECT_SOURCE_DIR}/tests/support/dense_algebra.cpp" LINKS Eigen3::Eigen)
ritz_test_library(serial_main SOURCES "${PROJECT_SOURCE_DIR}/tests/support/serial_main.cpp" LINKS Eigen3::Eigen)
if(RITZ_PRECOMPUTE)
  ritz_test_library(mpi_main SOURCES "${PROJECT_SOURCE_DIR}/tests/support/mpi_main.cpp" LINKS ritz_algebra)
endif()
set(RITZ_MPI_ENVIRONMENT
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_hwloc_base_binding_policy=none
  OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_btl_vader_single_copy_mechanism=none
  OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
  OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader PMIX_MCA_gds=hash HWLOC_COMPONENTS=-gl  # shared memory, and no search
  OMPI_MCA_odls_base_sigkill_timeout=0)  # else mpirun sleeps for a second whenever a program fails, as many tests want
# Serial tests look for leaks at exit, those under MPI before they finalize it (tests/support/mpi_main.cpp).
set(RITZ_LEAKS suppressions=${PROJECT_SOURCE_DIR}/tests/support/lsan.supp:print_suppressions=0)
set(RITZ_LEAKS_AT_EXIT LSAN_OPTIONS=${RITZ_LEAKS})
set(RITZ_LEAKS_BEFORE LSAN_OPTIONS=${RITZ_LEAKS}:leak_check_at_exit=0)

function(ritz_add_test name)
  cmake_parse_arguments(T "THOROUGH" "TIMEOUT;SHARED;LONG" "SOURCES;LINKS;RANKS" ${ARGN})
  if(NOT T_TIMEOUT)
    set(T_TIMEOUT 300)
  endif()
  set(target test_${name})
  add_executable(${target} ${T_SOURCES})
  list(TRANSFORM T_LINKS PREPEND ritz_)
  ritz_test_settings(${target})
  target_link_libraries(${target} PRIVATE ${T_LINKS})
  target_compile_definitions(${target} PRIVATE RITZ_SHARED="${PROJECT_SOURCE_DIR}/../shared"
    RITZ_SOURCE="${PROJECT_SOURCE_DIR}" RITZ_BIN="$<TARGET_FILE_DIR:${target}>")
  if(T_RANKS)
    target_link_libraries(${target} PRIVATE ritz_mpi_main)
  else()
    target_link_libraries(${target} PRIVATE ritz_serial_main)
  endif()
  set(apart "")
  if(T_SHARED AND NOT T_SHARED STREQUAL "*")
    ritz_run_test(${name}_shared ${target} "${T_SHARED}" ${T_TIMEOUT} "${T_RANKS}")
    list(APPEND apart "${T_SHARED}")
  endif()
  if(T_LONG)
    ritz_run_test(${name}_long ${target} "${T_LONG}" ${T_TIMEOUT} "${T_RANKS}")
    get_property(runs DIRECTORY PROPERTY TESTS)
    list(FILTER runs INCLUDE REGEX "^${name}_long(\\.|$)")
    set_tests_properties(${runs} PROPERTIES LABELS thorough)
    list(APPEND apart "${T_LONG}")
  endif()
  list(JOIN apart ":" apart)
  ritz_run_test(${name} ${target} "*-${apart}" ${T_TIMEOUT} "${T_RANKS}")
  if(T_THOROUGH)
    get_property(runs DIRECTORY PROPERTY TESTS)
    list(FILTER runs INCLUDE REGEX "^${name}(_shared|_long)?(\\.|$)")
    set_tests_properties(${runs} PROPERTIES LABELS thorough)
  else()
    add_dependencies(quick ${target})
  endif()
endfunction()

# Runs what a filter names, once for each number of ranks, or as a serial program where none is given.
function(ritz_run_test name target filter timeout numbers)
  set(command $<TARGET_FILE:${target}> --gtest_filter=${filter})
  foreach(ranks IN LISTS numbers)
    add_test(NAME ${name}.${ranks} COMMAND ${MPIEXEC} -n ${ranks} ${command})
    set_tests_properties(${name}.${ranks} PROPERTIES PROCESSORS ${ranks} TIMEOUT ${timeout}
      SKIP_RETURN_CODE 77 ENVIRONMENT "${RITZ_MPI_ENVIRONMENT};${RITZ_LEAKS_BEFORE}")
    if(NOT ranks EQUAL 2 AND 2 IN_LIST numbers)
      set_tests_properties(${name}.${ranks} PROPERTIES LABELS thorough)
    endif()
  endforeach()
  if(NOT numbers)
    add_test(NAME ${name} COMMAND ${command})
    set_tests_properties(${name} PROPERTIES TIMEOUT ${timeout} SKIP_RETURN_CODE 77
      ENVIRONMENT "${RITZ_MPI_ENVIRONMENT};${RITZ_LEAKS_AT_EXIT}")
  endif()
endfunction()

# ritz_add_script_test(NAME SCRIPT [ARGS ...] [TIMEOUT s]): a Python script, which finds what scripts and tests/support
# hold, and the module ritz; exit code 77 says "skipped".
function(ritz_add_script_test name script)
  cmake_parse_arguments(T "" "TIMEOUT;PROCESSORS" "ARGS" ${ARGN})
  if(NOT T_TIMEOUT)
    set(T_TIMEOUT 300)
  endif()
  if(NOT T_PROCESSORS)
    set(T_PROCESSORS 1)
  endif()
  add_test(NAME ${name} COMMAND /usr/bin/python3 "${script}" ${T_ARGS})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${T_TIMEOUT} PROCESSORS ${T_PROCESSORS} SKIP_RETURN_CODE 77
    ENVIRONMENT "${RITZ_MPI_ENVIRONMENT};${RITZ_LEAKS_BEFORE};RITZ_SHARED=${PROJECT_SOURCE_DIR}/../shared;RITZ_BIN=${PROJECT_BINARY_DIR}/bin;PYTHONPATH=${PROJECT_SOURCE_DIR}/scripts:${PROJECT_SOURCE_DIR}/tests/support:${PROJECT_BINARY_DIR}/python")
endfunction()
