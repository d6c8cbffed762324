// The tables of the scene file, by the struct that each describes.
#pragma once

#include "core/scene/keys.hpp"

namespace pf {

const Table& scene_table();
const Table& grid_table();
const Table& time_table();
const Table& integrator_table();
const Table& transfer_table();
const Table& solver_table();
const Table& view_table();
const Table& material_table();  ///< every law's parameters
const Table& body_table();
const Table& boundary_table();
const Table& constraint_table();
const Table& load_table();
const Table& probe_table();
const Table& event_table();
const Table& stroke_table();
const Table& shape_table();  ///< every shape's keys

/// What a shape stands for decides what is degenerate.
enum class ShapeUse { body, boundary, region };
void read_shape(Reader& reader, const Json& json, ShapeUse use, Shape& shape);
Json write_shape(const Shape& shape, const WriteStyle& style);
Json shape_schema();
/// Is a shape that was read well formed: not empty, bounded where it is a body, a polygon simple, ...?
void check_shape(Reader& reader, const Shape& shape, ShapeUse use);

void read_materials(Reader& reader, const Json& json, std::vector<Material>& materials);
Json write_materials(const std::vector<Material>& materials, bool defaults);
Json material_schema();

/// What single keys cannot say: names that refer to something, combinations that cannot work. `document` is what
/// was read, for what is a matter of presence.
void check_scene(Reader& reader, const Scene& scene, const Json& document);
/// Applies the events in the order of their times to the scene as written in `document`.
void check_events(Reader& reader, const Scene& scene, const Json& document);
/// Constants: names that expressions can use, finite numbers.
inline constexpr double largest_constant = 1e300;
Constants read_constants(Reader& reader, const Json& json);

/// The scene in `document`; what is wrong is among the reader's problems. `events`: check them, too.
Scene read_scene(Reader& reader, const Json& document, bool events);
/// The scene as a document; what equals its default is left out unless `defaults`.
Json scene_document(const Scene& scene, bool defaults);
/// What a reader needs to know before anything else is read.
int peek_dimension(const Json& document);

/// Sets one value in a document, defaults filled in along the way (INTERFACE fine print 3). False after a problem,
/// which carries the edit's own pointer. `changed`: the pointer without "-".
bool apply_edit(Json& document, const std::string& pointer, Json value, std::vector<Problem>& problems,
                std::string& changed);

}  // namespace pf
