# cmake -DOUTPUT=... -DFOLDER=... -P embed_shaders.cmake: every shaders/*.glsl as text in one .cpp, so that a binary
# needs no file beside it to draw.
file(GLOB shaders ${FOLDER}/*.glsl)
set(text "// Generated from shaders/*.glsl.\n#include \"render/program.hpp\"\n\nnamespace pf {\n\n")
string(APPEND text "std::string_view shader_source(std::string_view name) {\n")
foreach(shader ${shaders})
  get_filename_component(name ${shader} NAME_WE)
  file(READ ${shader} source)
  string(APPEND text "  if (name == \"${name}\") return R\"glsl(${source})glsl\";\n")
endforeach()
string(APPEND text "  return {};\n}\n\n}  // namespace pf\n")
file(WRITE ${OUTPUT} "${text}")
