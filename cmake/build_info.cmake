# What core/build_info.hpp reports: version, commit, compiler and flags. The commit is looked up when the program
# is built, and only when HEAD has moved; one small file is recompiled then.
target_sources(pf_core PRIVATE ${PROJECT_BINARY_DIR}/commit.cpp)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
get_target_property(shared_options pf_options INTERFACE_COMPILE_OPTIONS)
list(FILTER shared_options EXCLUDE REGEX "^-W")
list(JOIN shared_options " " shared_options)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${shared_options}" flags)
set_source_files_properties(core/build_info.cpp PROPERTIES COMPILE_DEFINITIONS
  "PUSHFORWARD_VERSION=\"${PROJECT_VERSION}\";PUSHFORWARD_COMPILER=\"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}\";PUSHFORWARD_FLAGS=\"${flags}\"")

# logs/HEAD changes with every commit, checkout and reset; a source archive has none of it.
set(head_files)
find_package(Git QUIET)
if(Git_FOUND)
  foreach(name HEAD logs/HEAD)
    execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse --git-path ${name}
      WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE path OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    get_filename_component(path "${path}" ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
    if(path AND EXISTS ${path} AND NOT IS_DIRECTORY ${path})
      list(APPEND head_files ${path})
    endif()
  endforeach()
endif()
add_custom_command(
  OUTPUT ${PROJECT_BINARY_DIR}/commit.cpp
  COMMAND ${CMAKE_COMMAND} -D GIT=${GIT_EXECUTABLE} -D SOURCE=${PROJECT_SOURCE_DIR}
    -D OUTPUT=${PROJECT_BINARY_DIR}/commit.cpp -P ${PROJECT_SOURCE_DIR}/cmake/write_commit.cmake
  DEPENDS ${head_files} ${PROJECT_SOURCE_DIR}/cmake/write_commit.cmake
  COMMENT "Looking up the commit" VERBATIM)
