#include "core/scene/tables.hpp"

#include "core/diagnostics/fields.hpp"
#include "core/scene/key_builder.hpp"

namespace pf {

const Table& grid_table() {
  static const Table table = [] {
    TableOf<GridSettings> t("Background grid");
    t.number(&GridSettings::spacing, "spacing", "Grid spacing", "m")
        .above(0)
        .at_most(1e6)
        .log_slider(0.005, 0.5)
        .required()
        .reset()
        .help(
            "Side dx of a grid cell; nodes lie at its integer multiples. Halve it to see whether a result has "
            "converged; "
            "cost grows with the inverse square (2D) or cube (3D).");
    t.choice(&GridSettings::basis, "basis", "Shape functions")
        .choices(basis_choices())
        .live()
        .help(
            "The functions that carry the motion from nodes to particles. Linear ones jump in gradient at cell faces; "
            "B-splines do not.");
    t.flag(&GridSettings::boundary_correction, "boundary_correction", "Boundary correction")
        .live()
        .help(
            "Lets splines end at walls and held regions whose face is a plane of nodes with all bodies on one side: "
            "what is held is then the motion at the wall itself, and errors there fall with the square of the spacing. "
            "Linear functions need none.");
    return t.take();
  }();
  return table;
}

const Table& time_table() {
  static const Table table = [] {
    TableOf<TimeSettings> t("Time");
    t.number(&TimeSettings::end, "end", "End", "s")
        .above(0)
        .at_most(1e9)
        .log_slider(0.1, 100)
        .live()
        .help("The run ends here; the last step is shortened to land on it.");
    t.number(&TimeSettings::step, "step", "Time step", "s")
        .above(0)
        .at_most(1e6)
        .log_slider(1e-5, 0.1)
        .live()
        .help(
            "Length dt of a step; with adaptive control the longest one. Backward Euler stays stable at any, but damps "
            "more as it grows; halve it to see whether a result has converged.");
    t.number(&TimeSettings::frame, "frame", "Frame interval", "s")
        .above(0)
        .at_most(1e9)
        .log_slider(1e-3, 1)
        .live()
        .help(
            "How often a picture or an export is due: at the first step that reaches each multiple. Absent: every "
            "step.");
    t.choice(&TimeSettings::control, "control", "Step control")
        .choices(step_control_choices())
        .live()
        .help(
            "How the length of a step is chosen. Adaptive: as long as the tolerance lets it be and no longer than the "
            "time step; symplectic Euler where that takes less counted work, else the time integrator (backward Euler "
            "where that is symplectic Euler).");
    t.number(&TimeSettings::tolerance, "tolerance", "Tolerance", "1/s")
        .above(0)
        .at_most(1e9)
        .log_slider(1e-4, 1)
        .live()
        .help(
            "With adaptive control: how far positions may drift off in a second, root mean square over the mass, as a "
            "share of the longest side of the largest body. Absent: 0.01.");
    return t.take();
  }();
  return table;
}

const Table& integrator_table() {
  static const Table table = [] {
    TableOf<IntegratorSettings> t("Time integration");
    t.choice(&IntegratorSettings::type, "type", "Time integrator")
        .choices(integrator_choices())
        .live()
        .help(
            "Implicit schemes solve for the end of the step by Newton's method; explicit ones need none but small "
            "steps.");
    t.choice(&IntegratorSettings::mass, "mass", "Inertia mass")
        .choices(mass_choices())
        .live()
        .help(
            "Mass matrix of the inertia term. Lumped is diagonal; the consistent one is more accurate and costs more.");
    t.number(&IntegratorSettings::ghost_penalty, "ghost_penalty", "Ghost penalty", "")
        .at_least(0)
        .at_most(10)
        .slider(0, 1)
        .live()
        .help(
            "Ties nodes at free edges that hold little mass to their neighbours, so that the consistent mass (of "
            "inertia or transfer) is safe there, and quasi-static steps, which no inertia holds; .01 to .5 is usual, 0 "
            "is none.");
    t.number(&IntegratorSettings::spectral_radius, "spectral_radius", "Spectral radius", "")
        .at_least(0)
        .at_most(1)
        .slider(0, 1)
        .live()
        .help(
            "What a step leaves of waves too short for it: 1 all of their amplitude, 0 nothing. Used by "
            "generalized_alpha only.");
    return t.take();
  }();
  return table;
}

const Table& transfer_table() {
  static const Table table = [] {
    TableOf<TransferSettings> t("Transfer between particles and grid");
    t.choice(&TransferSettings::type, "type", "Transfer")
        .choices(transfer_choices())
        .live()
        .help(
            "How particles take their velocity back from the grid: PIC damps, FLIP keeps energy, APIC keeps angular "
            "momentum.");
    t.number(&TransferSettings::flip_ratio, "flip_ratio", "FLIP ratio", "")
        .at_least(0)
        .at_most(1)
        .slider(0, 1)
        .live()
        .help(
            "Share of FLIP in the blend; the rest is PIC. 1 keeps energy and noise, 0 is pure PIC. Used by flip only.");
    t.integer(&TransferSettings::order, "order", "FMPM order")
        .at_least(1)
        .at_most(100)
        .slider(1, 10)
        .live()
        .help(
            "How far FMPM takes back what averaging smooths away: 1 is PIC, 2 to 4 lose little of what the grid can "
            "hold, "
            "many bring noise back and cost as many mass products. Used by fmpm only.");
    t.choice(&TransferSettings::velocity_mass, "velocity_mass", "Velocity-transfer mass")
        .choices(mass_choices())
        .live()
        .help(
            "Mass matrix by which momenta become node velocities. Consistent removes most of PIC's damping; it cannot "
            "be used with APIC.");
    return t.take();
  }();
  return table;
}

const Table& solver_table() {
  static const Table table = [] {
    TableOf<SolverSettings> t("Solver");
    t.number(&SolverSettings::newton_tolerance, "newton_tolerance", "Newton tolerance", "")
        .at_least(1e-14)
        .at_most(0.5)
        .log_slider(1e-10, 1e-1)
        .live()
        .help(
            "A step is accepted when the residual is below this share of the forces in play; it means the same at any "
            "stiffness, spacing and step.");
    t.integer(&SolverSettings::max_newton, "max_newton", "Most Newton iterations")
        .at_least(1)
        .at_most(10000)
        .slider(1, 100)
        .live()
        .help("After this many without convergence the step is tried again with a smaller dt.");
    t.flag(&SolverSettings::line_search, "line_search", "Line search")
        .live()
        .help(
            "Shortens a Newton step until the energy falls. Off takes every step whole, as textbooks write the method: "
            "far from the solution it runs away or turns material inside out, and the time step is begun again.");
    t.choice(&SolverSettings::linear, "linear", "Linear solver")
        .choices(solver_choices())
        .live()
        .help("Solves the linear system of each Newton iteration; every choice gives the same result to tolerance.");
    return t.take();
  }();
  return table;
}

const Table& view_table() {
  static const Table table = [] {
    std::vector<std::string> keys;
    for (const FieldInfo& field : fields()) keys.emplace_back(field.key);
    TableOf<ViewSettings> t("View");
    t.choice(&ViewSettings::color_by, "color_by", "Colour by")
        .choices(std::move(keys))
        .view()
        .help("The field of the particles or of the grid's nodes that is drawn as colour.");
    t.number(&ViewSettings::color_min, "color_min", "Least colour", "")
        .within(1e30)
        .view()
        .help(
            "Value of the colour map's lower end, in the field's unit; with color_max. By default both follow the "
            "field.");
    t.number(&ViewSettings::color_max, "color_max", "Largest colour", "")
        .within(1e30)
        .view()
        .help("Value of the colour map's upper end, above color_min.");
    t.flag(&ViewSettings::color_log, "color_log", "Logarithmic colours")
        .view()
        .help("Colours by the logarithm of the field's size; color_min must then be above zero.");
    return t.take();
  }();
  return table;
}

const Table& probe_table() {
  static const Table table = [] {
    TableOf<Probe> t("Probe");
    t.text(&Probe::name, "name", "Name")
        .at_least(1)
        .live()
        .help("Names the probe in probes.csv; \"probe1\", ... by default.");
    t.vector(&Probe::at, "at", "Reference point", "m")
        .within(1e9)
        .required()
        .live()
        .help("The particle nearest to this point of the reference body is followed.");
    return t.take();
  }();
  return table;
}

}  // namespace pf
