# SPDX-FileCopyrightText: The Triplex authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs the layers and the package `triplex`. Two export sets, so that a program that only needs
# the core does not need VTK: the core layers, and what reads, writes and draws.
#   find_package(triplex REQUIRED)                        triplex::triplex, the core layers
#   find_package(triplex REQUIRED COMPONENTS io render)   triplex::io, triplex::contour,
#                                                         triplex::flow, triplex::render as well
include(CMakePackageConfigHelpers)

get_property(layers GLOBAL PROPERTY TRIPLEX_LAYERS)
set(program_layers ${layers})
list(FILTER program_layers INCLUDE REGEX "^triplex_(io|contour|flow|render)$")
set(core_layers ${layers})
list(REMOVE_ITEM core_layers ${program_layers})

add_library(triplex INTERFACE)
add_library(triplex::triplex ALIAS triplex)
target_link_libraries(triplex INTERFACE ${core_layers})

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/triplex)
install(TARGETS triplex triplex_flags ${core_layers} EXPORT triplexTargets)
install(EXPORT triplexTargets NAMESPACE triplex:: DESTINATION ${package_dir})
if(program_layers)
  install(TARGETS ${program_layers} EXPORT triplexIoTargets)
  install(EXPORT triplexIoTargets NAMESPACE triplex:: DESTINATION ${package_dir})
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/triplex DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.hpp")

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/triplexConfig.cmake.in
  ${PROJECT_BINARY_DIR}/triplexConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/triplexConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/triplexConfig.cmake
  ${PROJECT_BINARY_DIR}/triplexConfigVersion.cmake ${PROJECT_SOURCE_DIR}/cmake/TriplexVtk.cmake
  DESTINATION ${package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
