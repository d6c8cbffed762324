#include "core/scene/scene_io.hpp"

#include <fstream>

#include "core/params/json_text.hpp"
#include "core/params/pointer.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

/// A regular file, or a pipe; never more than a scene may have.
std::string read_file(const std::filesystem::path& file) {
  const std::size_t most = JsonLimits{}.bytes;
  std::error_code error;
  const auto kind = std::filesystem::status(file, error).type();
  if (kind == std::filesystem::file_type::not_found) throw FileError(file.string() + ": there is no such file");
  if (kind == std::filesystem::file_type::directory) throw FileError(file.string() + ": is a folder, not a scene file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw FileError(file.string() + ": cannot be opened for reading");
  std::string text(std::min<std::size_t>(most + 1, 1 << 16), '\0');
  std::size_t size = 0;
  while (in.read(text.data() + size, static_cast<std::streamsize>(text.size() - size)), in.gcount() > 0) {
    size += static_cast<std::size_t>(in.gcount());
    if (size > most) {
      throw InputError(file.string(), {Problem{"", "more than " + std::to_string(most) + " bytes",
                                               "at most that many in a scene file", 0}});
    }
    if (size == text.size()) text.resize(std::min(2 * size, most + 1));
  }
  if (in.bad()) throw FileError(file.string() + ": reading failed");
  text.resize(size);
  return text;
}

/// Names that the file leaves out.
void fill_names(Scene& scene) {
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (scene.bodies[k].name.empty()) scene.bodies[k].name = "body" + std::to_string(k + 1);
  }
  for (std::size_t k = 0; k < scene.probes.size(); ++k) {
    if (scene.probes[k].name.empty()) scene.probes[k].name = "probe" + std::to_string(k + 1);
  }
}

/// Lines of problems that the text, not an edit, has brought.
void find_lines(std::vector<Problem>& problems, std::string_view text, const std::vector<std::string>& changed) {
  std::vector<std::string> pointers;
  std::vector<Problem*> wanted;
  for (Problem& problem : problems) {
    bool edited = problem.line > 0;
    for (const std::string& pointer : changed) edited = edited || is_at_or_below(problem.pointer, pointer);
    if (edited) continue;
    pointers.push_back(problem.pointer);
    wanted.push_back(&problem);
  }
  if (wanted.empty()) return;
  const std::vector<int> lines = json_lines(text, pointers);
  for (std::size_t k = 0; k < lines.size(); ++k) wanted[k]->line = lines[k];
}

/// Edits, then reads; throws every problem.
Scene read_document(Json& document, std::span<const Edit> edits, std::string_view text, const std::string& source,
                    std::vector<Problem> problems) {
  std::vector<std::string> changed;
  for (const Edit& edit : edits) {
    std::string pointer;
    if (apply_edit(document, edit.pointer, Json(edit.value), problems, pointer)) changed.push_back(std::move(pointer));
  }
  const std::size_t before = problems.size();
  Reader reader(peek_dimension(document), {});
  Scene scene = read_scene(reader, document, true);
  for (Problem& problem : reader.take_problems()) problems.push_back(std::move(problem));
  if (!text.empty() && problems.size() > before) find_lines(problems, text, changed);
  if (!problems.empty()) throw InputError(source, std::move(problems));
  return scene;
}

}  // namespace

Scene read_scene(Reader& outer, const Json& document, bool events) {
  Scene scene;
  if (!document.is_object()) {
    outer.refuse(describe(document), "a scene: an object { ... }");
    return scene;
  }
  // Expressions need the constants, whatever the order in the file; their own problems come when they are read again.
  Reader quiet(outer.dimension(), {});
  Reader reader(outer.dimension(),
                document.contains("constants") ? read_constants(quiet, document["constants"]) : Constants{});
  read_table(reader, scene_table(), document, &scene);
  fill_names(scene);
  check_scene(reader, scene, document);
  if (events && reader.refused() == 0) check_events(reader, scene, document);
  outer.take_from(reader);
  return scene;
}

Scene parse_scene(std::string_view text, const std::string& source, std::span<const Edit> edits) {
  std::vector<Problem> problems;
  Json document = read_json(text, source, problems);
  return read_document(document, edits, text, source, std::move(problems));
}

Scene load_scene(const std::filesystem::path& file, std::span<const Edit> edits) {
  return parse_scene(read_file(file), file.string(), edits);
}

Scene edited(const Scene& scene, std::span<const Edit> edits) {
  Json document = scene_document(scene, false);
  return read_document(document, edits, "", "", {});
}

Edit parse_set(std::string_view argument) {
  const std::size_t equals = argument.find('=');
  if (equals == std::string_view::npos || !argument.starts_with('/')) {
    throw InputError("--set",
                     {Problem{"", quoted_excerpt(argument), "/pointer=VALUE, for instance /time/step=0.005", 0}});
  }
  const std::string_view value = argument.substr(equals + 1);
  Edit edit{std::string(argument.substr(0, equals)), std::string(value)};
  std::vector<Problem> problems;
  try {
    const Json json = read_json(value, problems);
    if (problems.empty()) edit.value = nlohmann::json(json);
  } catch (const InputError&) {
    // Text that is not JSON is a string.
  }
  if (!problems.empty()) throw InputError("--set " + edit.pointer, std::move(problems));
  return edit;
}

}  // namespace pf
