// The tables of what a scene is made of: bodies, boundaries, constraints, loads; and of strokes.
#include "core/scene/key_builder.hpp"
#include "core/scene/tables.hpp"

namespace pf {
namespace {

/// A key that holds a shape.
template <class T>
void add_shape(TableOf<T>& t, Shape T::*member, ShapeUse use, std::string key, std::string label, std::string help) {
  Key& row = t.own(Nesting::object, shape_table, std::move(key), std::move(label));
  row.setting.required = true;
  row.setting.applies = Applies::reset;
  row.setting.help = std::move(help);
  row.read = [=](Reader& r, const Json& j, void* o) { read_shape(r, j, use, static_cast<T*>(o)->*member); };
  row.write = [=](const void* o, const WriteStyle& style) {
    return write_shape(static_cast<const T*>(o)->*member, style);
  };
}

}  // namespace

const Table& body_table() {
  static const Table table = [] {
    TableOf<Body> t("Body");
    t.text(&Body::name, "name", "Name")
        .at_least(1)
        .reset()
        .help("Loads refer to it; \"body1\", \"body2\", ... by default.");
    t.text(&Body::material, "material", "Material").at_least(1).required().reset().help("A key of \"materials\".");
    add_shape(t, &Body::shape, ShapeUse::body, "shape", "Shape", "The reference body; it must be bounded.");
    t.formulas(&Body::velocity, mask_reference, false, "velocity", "Initial velocity", "m/s")
        .within(1e9)
        .slider(-10, 10)
        .reset()
        .help("At t = 0, as a function of the reference position X Y Z.");
    t.integer(&Body::particles_per_axis, "particles_per_axis", "Particles per cell and axis")
        .at_least(1)
        .at_most(32)
        .slider(1, 6)
        .reset()
        .help("2 gives 4 particles a cell in 2D and 8 in 3D. More bear larger stretch before the body tears.");
    t.choice(&Body::sampling, "sampling", "Sampling")
        .choices(sampling_choices())
        .reset()
        .help("How the particles are laid out at the start.");
    t.integer(&Body::seed, "seed", "Seed")
        .at_least(0)
        .at_most(18446744073709549568.0)  // the largest double below 2^64
        .slider(0, 100)
        .reset()
        .help("Of the random numbers of jittered and Poisson-disc sampling.");
    return t.take();
  }();
  return table;
}

const Table& boundary_table() {
  static const Table table = [] {
    TableOf<Boundary> t("Boundary");
    add_shape(t, &Boundary::shape, ShapeUse::boundary, "shape", "Shape", "The boundary is solid where the shape is.");
    t.flag(&Boundary::invert, "invert", "Container")
        .reset()
        .help("Solid outside the shape instead of inside: a container.");
    t.choice(&Boundary::contact, "contact", "Contact")
        .choices(contact_choices())
        .live()
        .help("What material that touches may do.");
    t.number(&Boundary::friction, "friction", "Friction", "")
        .at_least(0)
        .at_most(100)
        .slider(0, 1)
        .live()
        .help("Coulomb's coefficient: the tangential force is at most this times the normal one.");
    t.formulas(&Boundary::velocity, mask_time, false, "velocity", "Velocity", "m/s")
        .within(1e9)
        .slider(-10, 10)
        .live()
        .help("Of the whole shape, as a function of time t; the shape moves along.");
    return t.take();
  }();
  return table;
}

const Table& constraint_table() {
  static const Table table = [] {
    TableOf<Constraint> t("Constraint");
    add_shape(t, &Constraint::region, ShapeUse::region, "region", "Region", "Grid nodes inside it are held.");
    t.flags(&Constraint::fix, "fix", "Components")
        .required()
        .live()
        .help("Which components of the motion are prescribed.");
    t.formulas(&Constraint::velocity, mask_time, false, "velocity", "Velocity", "m/s")
        .within(1e9)
        .slider(-10, 10)
        .live()
        .help("Prescribed velocity of the fixed components, as a function of time t.");
    return t.take();
  }();
  return table;
}

const Table& stroke_table() {
  static const Table table = [] {
    TableOf<Stroke> t("Stroke");
    t.choice(&Stroke::kind, "kind", "Kind")
        .choices(stroke_choices())
        .required()
        .reset()
        .help("What is done to the particles.");
    add_shape(t, &Stroke::shape, ShapeUse::region, "shape", "Shape",
              "The particles that are within it when the event applies are meant.");
    t.leaf(
         SettingKind::text, "material", "Material", "",
         [](Reader& r, const Json& j, const Setting& s, Stroke& o) { return read_text(r, j, s, o.material); },
         [](const Stroke& o, const WriteStyle&) {
           return o.material.empty() ? std::nullopt : std::optional<Json>(o.material);
         })
        .at_least(1)
        .reset()
        .help("Of paint: a key of \"materials\".");
    return t.take();
  }();
  return table;
}

const Table& load_table() {
  static const Table table = [] {
    TableOf<Load> t("Load");
    t.text(&Load::body, "body", "Body")
        .at_least(1)
        .required()
        .reset()
        .help("The name of the body that carries the load.");
    add_shape(t, &Load::region, ShapeUse::region, "region", "Region",
              "The load acts on the body's reference surface inside this region.");
    Row row = t.formulas(&Load::traction, mask_all, false, "traction", "Traction", "Pa");
    row.within(1e18).slider(-1e4, 1e4).required().live().help(
        "Force per reference area, as a function of reference position X Y Z, current position x y z and time t; its "
        "integral is the total force.");
    return t.take();
  }();
  return table;
}

}  // namespace pf
