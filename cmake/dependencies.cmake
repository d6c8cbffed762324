# Packaged libraries only (scripts/packages.tsv names the packages). Each is found the way its package offers itself.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(glfw3 3.3 REQUIRED)
find_package(glm REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
# Debian's package of Dear ImGui brings a .pc file; others only the library and its headers.
pkg_check_modules(imgui IMPORTED_TARGET imgui)
if(NOT TARGET PkgConfig::imgui)
  find_path(IMGUI_INCLUDE_DIR imgui.h PATH_SUFFIXES imgui REQUIRED)
  find_library(IMGUI_LIBRARY imgui REQUIRED)
  add_library(PkgConfig::imgui UNKNOWN IMPORTED)
  set_target_properties(PkgConfig::imgui PROPERTIES IMPORTED_LOCATION ${IMGUI_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${IMGUI_INCLUDE_DIR})
endif()
if(PUSHFORWARD_TESTS)
  find_package(doctest REQUIRED)
endif()
# stb is header-only here; CLI11 too.
find_path(STB_INCLUDE_DIR stb/stb_image_write.h REQUIRED)
find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp REQUIRED)
