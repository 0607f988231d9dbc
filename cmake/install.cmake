# What `cmake --install` adds to the libraries and their headers (asterism_library): the program,
# the data files, and the package for find_package(asterism).
include(CMakePackageConfigHelpers)

set(ASTERISM_AXIOMS_DIR ${CMAKE_INSTALL_DATADIR}/asterism/axioms)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/asterism)

install(TARGETS asterism RUNTIME)
install(DIRECTORY axioms/ DESTINATION ${ASTERISM_AXIOMS_DIR}
  FILES_MATCHING PATTERN "*.smt2")
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/asterism/schemas
  FILES_MATCHING PATTERN "*.schema.json")
install(EXPORT asterism NAMESPACE asterism:: FILE asterismTargets.cmake DESTINATION ${package_dir})

# A user's linker needs what our static libraries were made with; headers of ours that are not
# installed and libraries kept in $<BUILD_INTERFACE:...> are no concern of theirs.
set(links "")
foreach(library core axioms planarity engine perception metric simulation io)
  if(TARGET asterism_${library})
    get_target_property(own asterism_${library} INTERFACE_LINK_LIBRARIES)
    list(APPEND links ${own})
  endif()
endforeach()
string(GENEX_STRIP "${links}" public_links)
string(REGEX MATCHALL "\\$<LINK_ONLY:[A-Za-z0-9_]+::[A-Za-z0-9_-]+>" private_links "${links}")
set(links "${public_links};${private_links}")

set(ASTERISM_DEPENDENCIES "")
if(links MATCHES "PkgConfig::Z3")
  string(APPEND ASTERISM_DEPENDENCIES
    "find_dependency(PkgConfig)\n"
    "pkg_check_modules(Z3 REQUIRED IMPORTED_TARGET z3)\n")
endif()
foreach(package fmt nlohmann_json Boost ZLIB LibLZMA PNG Ceres Eigen3)
  if(links MATCHES "${package}::")
    string(APPEND ASTERISM_DEPENDENCIES "find_dependency(${package})\n")
  endif()
endforeach()

configure_package_config_file(cmake/asterismConfig.cmake.in asterismConfig.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS ASTERISM_AXIOMS_DIR)
write_basic_package_version_file(asterismConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/asterismConfig.cmake
              ${PROJECT_BINARY_DIR}/asterismConfigVersion.cmake
  DESTINATION ${package_dir})
