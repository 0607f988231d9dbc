# Warnings are the project's own business: never exported, errors only where asked for.
add_library(asterism_warnings INTERFACE)
target_compile_options(asterism_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
  -Woverloaded-virtual -Wold-style-cast
  # g++ 12 sees overlaps in "literal" + std::string that are not there (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${ASTERISM_WERROR}>:-Werror>)

add_library(asterism_sanitizers INTERFACE)
if(ASTERISM_SANITIZE)
  target_compile_options(asterism_sanitizers INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(asterism_sanitizers INTERFACE -fsanitize=address,undefined)
endif()
if(ASTERISM_FUZZ)
  target_compile_options(asterism_sanitizers INTERFACE -fsanitize=fuzzer-no-link)
endif()

# asterism_library(name HEADERS ... SOURCES ... LINKS ... PRIVATE_LINKS ...)
# makes asterism::name from the current folder, with its install rule: a component of the package.
function(asterism_library name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "HEADERS;SOURCES;LINKS;PRIVATE_LINKS")
  set(target asterism_${name})
  add_library(${target} STATIC)
  add_library(asterism::${name} ALIAS ${target})
  target_sources(${target}
    PRIVATE ${ARG_SOURCES}
    PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ARG_HEADERS})
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name} CXX_EXTENSIONS OFF VERIFY_INTERFACE_HEADER_SETS ON)
  target_link_libraries(${target}
    PUBLIC ${ARG_LINKS}
    PRIVATE ${ARG_PRIVATE_LINKS} $<BUILD_INTERFACE:asterism_warnings>
            $<BUILD_INTERFACE:asterism_sanitizers>)
  set_property(GLOBAL APPEND PROPERTY ASTERISM_LIBRARIES ${name})
  install(TARGETS ${target} EXPORT ${target} FILE_SET HEADERS
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/asterism)
  target_include_directories(${target} INTERFACE
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/asterism>)
endfunction()

# asterism_for_plugins(name) lets asterism::name become part of a shared library too, as a
# detector's plug-in needs it, and stay as fast as it was.
function(asterism_for_plugins name)
  set_target_properties(asterism_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(asterism_${name} PRIVATE -fno-semantic-interposition)
endfunction()
