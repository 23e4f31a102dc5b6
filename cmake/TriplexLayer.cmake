# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Flags that every translation unit of Triplex shares. The filters' error bounds assume IEEE double
# operations, each rounded once: no contraction to FMA, no fast-math.
add_library(triplex_flags INTERFACE)
add_library(triplex::flags ALIAS triplex_flags)
set_target_properties(triplex_flags PROPERTIES EXPORT_NAME flags)
target_compile_features(triplex_flags INTERFACE cxx_std_20)
target_compile_options(triplex_flags INTERFACE -ffp-contract=off -fno-fast-math)
add_library(triplex_warnings INTERFACE)
target_compile_options(triplex_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow
  $<$<BOOL:${TRIPLEX_WERROR}>:-Werror>
  # GCC 12 sees out-of-bounds writes in inlined library code (fmt, std::sort) where there are none.
  $<$<AND:$<BOOL:${TRIPLEX_WERROR}>,$<CXX_COMPILER_ID:GNU>>:-Wno-error=array-bounds
  -Wno-error=stringop-overflow -Wno-error=stringop-overread -Wno-error=restrict
  -Wno-error=maybe-uninitialized -Wno-error=use-after-free -Wno-error=free-nonheap-object>)
if(TRIPLEX_SANITIZE)
  target_compile_options(triplex_flags INTERFACE -fsanitize=${TRIPLEX_SANITIZE}
    -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(triplex_flags INTERFACE -fsanitize=${TRIPLEX_SANITIZE})
endif()

# triplex_layer(NAME SOURCES ... [DEPENDS ...] [PRIVATE_DEPENDS ...])
# One static library per layer of the design: target triplex_NAME, alias triplex::NAME.
function(triplex_layer name)
  cmake_parse_arguments(LAYER "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(triplex_${name} STATIC ${LAYER_SOURCES})
  add_library(triplex::${name} ALIAS triplex_${name})
  set_target_properties(triplex_${name} PROPERTIES EXPORT_NAME ${name}
    POSITION_INDEPENDENT_CODE ON CXX_EXTENSIONS OFF)
  target_include_directories(triplex_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(triplex_${name} PUBLIC triplex_flags ${LAYER_DEPENDS}
    PRIVATE $<BUILD_INTERFACE:triplex_warnings> ${LAYER_PRIVATE_DEPENDS})
  set_property(GLOBAL APPEND PROPERTY TRIPLEX_LAYERS triplex_${name})
endfunction()

# triplex_test(NAME SOURCE LIBRARIES... [LABELS ...])
# One GoogleTest executable per test file; its cases are registered with ctest. At most one label:
# `slow` or `install`; those are left out under sanitizers.
function(triplex_test name source)
  cmake_parse_arguments(TEST "" "" "LIBRARIES;LABELS" ${ARGN})
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE ${TEST_LIBRARIES} triplex_warnings GTest::gtest_main)
  if(TRIPLEX_SANITIZE AND TEST_LABELS)  # not run, so not built
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  set(properties TIMEOUT 1500)
  if(TEST_LABELS)
    list(APPEND properties LABELS ${TEST_LABELS})
  endif()
  gtest_discover_tests(${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60
    PROPERTIES ${properties})
endfunction()
