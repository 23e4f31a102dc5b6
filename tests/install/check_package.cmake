# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs a build into a fresh prefix, then configures, builds and runs a program that finds the
# package there and nowhere else.
#   cmake -D BUILD=.. -D SCRATCH=.. -D CONSUMER=.. -D PROGRAM=.. -D GENERATOR=.. -D COMPILER=..
#         [-D EXPECT=REGEX] [-D FIELD=..] -P check_package.cmake
# With FIELD the program is called with that file and a directory for its results.
foreach(variable BUILD SCRATCH CONSUMER PROGRAM GENERATOR COMPILER)
  if(NOT DEFINED ${variable})
    message(FATAL_ERROR "${variable} is not set")
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  message("${output}${errors}")
  if(NOT code EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "failed with ${code}: ${command}")
  endif()
  set(run_output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH}/results)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH}/build -G ${GENERATOR}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release
  -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix)
file(STRINGS ${SCRATCH}/build/CMakeCache.txt found REGEX "^triplex_DIR:")
if(NOT found MATCHES "${SCRATCH}/prefix/")
  message(FATAL_ERROR "another triplex was found: ${found}")
endif()
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
set(arguments)
if(DEFINED FIELD)
  set(arguments ${FIELD} ${SCRATCH}/results)
endif()
run(${SCRATCH}/build/${PROGRAM} ${arguments})
if(DEFINED EXPECT AND NOT run_output MATCHES "${EXPECT}")
  message(FATAL_ERROR "the output does not match '${EXPECT}'")
endif()
file(REMOVE_RECURSE ${SCRATCH})
