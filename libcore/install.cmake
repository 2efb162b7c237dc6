# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install`: the targets that other programs use, for find_package(impinge). The core comes with Eigen alone; what
# needs more is a component of its own, so that nobody looks for a library that a program does not use.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/impinge)
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/impinge)

add_custom_target(library) # all that is installed, and nothing else

# impinge_install(COMPONENT name LIBRARIES library...)
function(impinge_install)
  cmake_parse_arguments(arg "" "COMPONENT" "LIBRARIES" ${ARGN})
  foreach(library IN LISTS arg_LIBRARIES)
    target_include_directories(impinge_${library} PUBLIC $<INSTALL_INTERFACE:${header_dir}>)
    target_compile_features(impinge_${library} PUBLIC cxx_std_20)
    add_dependencies(library impinge_${library})
    install(TARGETS impinge_${library} EXPORT impinge-${arg_COMPONENT} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    if(IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/${library})
      install(DIRECTORY ${library} DESTINATION ${header_dir} FILES_MATCHING PATTERN *.hpp PATTERN *-inl.hpp EXCLUDE)
    endif()
  endforeach()
  install(EXPORT impinge-${arg_COMPONENT} NAMESPACE impinge:: DESTINATION ${package_dir})
endfunction()

impinge_install(COMPONENT core LIBRARIES files sphere mesh table gap contact planning anatomy hip limits rotations change)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/sphere/generated/sphere/scheme_list.hpp DESTINATION ${header_dir}/sphere)
if(NOT IMPINGE_CORE_ONLY)
  impinge_install(COMPONENT mesh_io LIBRARIES mesh_io)
  impinge_install(COMPONENT simd LIBRARIES gap_simd documents landmarks pose_list joint)
else() # the headers of planning
  install(DIRECTORY joint DESTINATION ${header_dir} FILES_MATCHING PATTERN *.hpp)
endif()

configure_file(impinge-config.cmake.in impinge-config.cmake @ONLY)
write_basic_package_version_file(impinge-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/impinge-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/impinge-config-version.cmake
        DESTINATION ${package_dir})
