# What `cmake --install` adds to the libraries and their headers (asterism_library): the program,
# the data files, and the package for find_package(asterism), each library one of its components.
include(CMakePackageConfigHelpers)

set(ASTERISM_AXIOMS_DIR ${CMAKE_INSTALL_DATADIR}/asterism/axioms)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/asterism)

install(TARGETS asterism RUNTIME)
install(DIRECTORY axioms/ DESTINATION ${ASTERISM_AXIOMS_DIR}
  FILES_MATCHING PATTERN "*.smt2")
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/asterism/schemas
  FILES_MATCHING PATTERN "*.schema.json")

# A user's linker needs what our static libraries were made with; headers of ours that are not
# installed and libraries kept in $<BUILD_INTERFACE:...> are no concern of theirs.
get_property(ASTERISM_LIBRARIES GLOBAL PROPERTY ASTERISM_LIBRARIES)
set(ASTERISM_NEEDS "")
foreach(library IN LISTS ASTERISM_LIBRARIES)
  install(EXPORT asterism_${library} NAMESPACE asterism:: FILE asterism_${library}.cmake
    DESTINATION ${package_dir})
  get_target_property(links asterism_${library} INTERFACE_LINK_LIBRARIES)
  string(GENEX_STRIP "${links}" public_links)
  string(REGEX MATCHALL "\\$<LINK_ONLY:[A-Za-z0-9_]+::[A-Za-z0-9_-]+>" private_links "${links}")
  string(REGEX MATCHALL "[A-Za-z0-9_]+::[A-Za-z0-9_-]+" links "${public_links};${private_links}")
  set(libraries ${links})
  list(FILTER libraries INCLUDE REGEX "^asterism::")
  list(TRANSFORM libraries REPLACE "^asterism::" "")
  set(packages ${links})
  list(FILTER packages EXCLUDE REGEX "^asterism::")
  list(TRANSFORM packages REPLACE "^PkgConfig::" "")
  list(TRANSFORM packages REPLACE "::.*$" "")
  string(APPEND ASTERISM_NEEDS
    "set(asterism_${library}_libraries ${libraries})\n"
    "set(asterism_${library}_packages ${packages})\n")
endforeach()

configure_package_config_file(cmake/asterismConfig.cmake.in asterismConfig.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS ASTERISM_AXIOMS_DIR)
write_basic_package_version_file(asterismConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/asterismConfig.cmake
              ${PROJECT_BINARY_DIR}/asterismConfigVersion.cmake
  DESTINATION ${package_dir})
