// The scene: a plain value, checked once when it is read. Members mirror the scene file key by key.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace pf {

/// A place in a scene and a value for it: what --set, events, studies and panels have in common.
struct Edit {
  std::string pointer;   ///< JSON pointer, "-" appends to an array
  nlohmann::json value;  ///< the new value
  bool operator==(const Edit&) const = default;
};

/// A number, or the text of an expression (core/math/expression.hpp) that gives one.
struct Formula {
  double number = 0;  ///< used when `text` is empty
  std::string text;
  bool is_number() const { return text.empty(); }
  bool operator==(const Formula&) const = default;
};
/// One formula a component; `dimension` of them are used.
using FormulaVector = std::vector<Formula>;

/// A set of points; which members count depends on `type` (the contract's list of shapes). Components beyond
/// the scene's dimension are 0.
struct Shape {
  std::string type;  ///< box ball cylinder polygon half_space where union difference intersection
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();
  Vec3 center = Vec3::Zero();
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  double radius = 0;
  std::vector<Vec3> points;
  Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
  std::string where;  ///< expression, inside where > 0
  std::vector<Shape> of;
  // Applied in this order about the shape's centre.
  double scale = 1;
  double rotate_degrees = 0;
  Vec3 rotate_axis = Vec3::UnitZ();
  Vec3 translate = Vec3::Zero();
  bool operator==(const Shape&) const = default;
};

struct GridSettings {
  double spacing = 0;  ///< dx [m]
  std::string basis = "quadratic";
  bool boundary_correction = false;  ///< open knots at walls that are planes of nodes
  bool operator==(const GridSettings&) const = default;
};

/// Relative displacement error a unit of time where a scene with adaptive steps says none [1/s].
inline constexpr double default_tolerance = 1e-2;

struct TimeSettings {
  double end = 1;               ///< [s]
  double step = 0.01;           ///< dt [s]; with adaptive control the longest one
  std::optional<double> frame;  ///< interval of pictures and exports [s]; absent: every step
  std::string control = "fixed";
  std::optional<double> tolerance;  ///< of adaptive control [1/s]; absent: default_tolerance
  bool operator==(const TimeSettings&) const = default;
};

struct IntegratorSettings {
  std::string type = "backward_euler";
  std::string mass = "lumped";   ///< inertia mass
  double ghost_penalty = 0;      ///< of a consistent mass, either one, or of a quasi-static step
  double spectral_radius = 0.8;  ///< of generalised-alpha
  bool operator==(const IntegratorSettings&) const = default;
};

struct TransferSettings {
  std::string type = "flip";
  double flip_ratio = 0.95;
  int order = 2;  ///< of FMPM
  std::string velocity_mass = "lumped";
  bool operator==(const TransferSettings&) const = default;
};

struct SolverSettings {
  double newton_tolerance = 1e-6;  ///< THEORY T4
  int max_newton = 50;
  bool line_search = true;  ///< off: Newton's full step, whatever it does to E
  std::string linear = "auto";
  bool operator==(const SolverSettings&) const = default;
};

struct Material {
  std::string name;  ///< its key in "materials"
  std::string model;
  double density = 0;                                      ///< R0 [kg/m^3]
  std::vector<std::pair<std::string, double>> parameters;  ///< in the order of LawInfo::parameters
  bool f_bar = false;                                      ///< particles of a cell share their change of volume
  bool operator==(const Material&) const = default;
};

struct Body {
  std::string name;
  std::string material;
  Shape shape;
  FormulaVector velocity;  ///< [m/s], in X Y Z
  int particles_per_axis = 2;
  std::string sampling = "lattice";
  std::uint64_t seed = 0;
  bool operator==(const Body&) const = default;
};

struct Boundary {
  Shape shape;
  bool invert = false;  ///< solid outside the shape: a container
  std::string contact = "separate";
  double friction = 0;     ///< Coulomb's coefficient
  FormulaVector velocity;  ///< [m/s], in t
  bool operator==(const Boundary&) const = default;
};

struct Constraint {
  Shape region;
  std::vector<bool> fix;   ///< one a component
  FormulaVector velocity;  ///< [m/s], in t
  bool operator==(const Constraint&) const = default;
};

struct Load {
  std::string body;
  Shape region;
  FormulaVector traction;  ///< nominal [Pa], in X Y Z x y z t
  bool operator==(const Load&) const = default;
};

struct Probe {
  std::string name;
  Vec3 at = Vec3::Zero();  ///< reference point; the nearest particle is followed
  bool operator==(const Probe&) const = default;
};

/// What a hand does to the particles of a running simulation, once: those within the shape are meant, where they are.
struct Stroke {
  std::string kind = "cut";  ///< "cut" takes them away, "paint" gives them another material; their F stays
  Shape shape;               ///< in current space
  std::string material;      ///< paint: its key in "materials"; cut: empty
  bool operator==(const Stroke&) const = default;
};

struct Event {
  double time = 0;  ///< applied at the first step at or after it [s]
  std::vector<Edit> set;
  std::vector<Stroke> strokes;  ///< after `set`, in this order
  bool operator==(const Event&) const = default;
};

struct ViewSettings {
  std::string color_by = "speed";
  std::optional<double> color_min, color_max;  ///< ends of the colour map, in the field's unit; neither: automatic
  bool color_log = false;
  bool operator==(const ViewSettings&) const = default;
};

struct Scene {
  std::string name, about;
  int dimension = 2;
  std::vector<std::pair<std::string, double>> constants;
  Vec3 gravity = Vec3::Zero();  ///< [m/s^2]
  FormulaVector body_force;     ///< [m/s^2], in X Y Z x y z t; empty: none
  GridSettings grid;
  TimeSettings time;
  IntegratorSettings integrator;
  TransferSettings transfer;
  SolverSettings solver;
  std::vector<Material> materials;
  std::vector<Body> bodies;
  std::vector<Boundary> boundaries;
  std::vector<Constraint> constraints;
  std::vector<Load> loads;
  FormulaVector exact_position;  ///< known motion x(X, t); empty: none
  bool manufactured = false;
  std::vector<Probe> probes;
  std::vector<Event> events;
  ViewSettings view;
  bool operator==(const Scene&) const = default;
};

}  // namespace pf
