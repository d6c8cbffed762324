// The simulation in D dimensions: owns particles and grid; step() reads like THEORY T3 to T5.
#pragma once

#include <algorithm>
#include <chrono>
#include <numeric>

#include "core/control/step_control.hpp"
#include "core/energies/elastic.hpp"
#include "core/energies/grab.hpp"
#include "core/integrators/integrator.hpp"
#include "core/look.hpp"
#include "core/scene/sampling.hpp"
#include "core/simulation.hpp"
#include "core/step/conditions.hpp"
#include "core/step/known_motion.hpp"
#include "core/step/loads.hpp"
#include "core/step/rigid_motion.hpp"
#include "core/transfers/transfer.hpp"

namespace pf {

/// The friction of a node in the last step: where the next one's iteration begins.
template <int D>
struct RubbingNode {
  std::array<long long, D> index;
  Vec<D> normal;
  double bound;  ///< mu f_n [N]
};

template <int D>
class SimulationOf final : public Simulation {
 public:
  SimulationOf(const Scene& scene, const SimulationOptions& options);

  const Scene& scene() const override { return scene_; }
  std::size_t particle_count() const override { return particles_.size(); }
  double mass() const override { return std::accumulate(particles_.mass.begin(), particles_.mass.end(), 0.0); }
  double time() const override { return time_; }
  const StepReport& report() const override { return accepted_; }
  const StepReport& step(const std::atomic<bool>* cancel) override;
  void set_end(double end) override { end_ = end; }
  bool apply(const Scene& scene) override;
  void set_ledger(bool on) override { ledger_ = on; }
  void set_grab(const std::optional<Grab>& grab) override;
  std::size_t stroke(const Stroke& stroke) override;
  void capture(const SnapshotRequest& request, Snapshot& into) const override;
  std::vector<ProbeReading> probes() const override;
  std::vector<ParticleState> particles() const override;
  ParticleState particle(std::uint32_t id) const override;
  bool has_particle(std::uint32_t id) const override { return place_of(id) < particles_.size(); }
  Look look(const LookQuestion& question) const override;
  void set_recording(RecordLevel level) override { recording_ = level; }
  std::shared_ptr<const StepRecord> record() const override { return record_; }
  double stable_step() const override;
  std::string solver_choice() const override;
  void save_state(std::ostream& out) const override;
  void load_state(std::istream& in) override;

 private:
  /// What an attempted step came to.
  struct Attempt {
    enum Outcome { accepted, cancelled, failed, refused, inexact } outcome = accepted;
    std::string reason = {};  ///< of failure, for the user; "refused": no smaller dt would help
    StepChoice instead = {};  ///< of a step that was too inexact
  };
  class Stages;
  /// What "auto" has counted of solves, in iterations of block-Jacobi; 0: not yet.
  struct SolveCosts {
    std::string solver;  ///< of the last accepted step that solved something
    double jacobi = 0, multigrid = 0;
    double steps = 0;  ///< with multigrid, since block-Jacobi was counted
  };
  /// The grid of the last accepted step, for pictures.
  struct LastGrid {
    std::vector<std::array<long long, D>> index;
    Vector mass, v, u;
    std::vector<std::uint8_t> state;
  };

  /// Where a particle is in the arrays; their size where there is none.
  std::size_t place_of(std::uint32_t id) const {
    return static_cast<std::size_t>(std::find(particles_.id.begin(), particles_.id.end(), id) - particles_.id.begin());
  }
  /// By id: how many of the particles that are there have a smaller one.
  std::vector<std::uint32_t> ranks() const;
  static double size_of(const Particles<D>& particles, double spacing);
  /// A probe's particle, chosen when it was placed.
  struct Followed {
    Vec<D> at;
    std::uint32_t id;
  };
  /// The scene's probes; those that are among `known` keep their particle.
  void follow_probes(const std::vector<Followed>& known);
  void take_away(const std::vector<char>& gone);
  void repaint(const std::vector<char>& meant, std::uint16_t material);
  void add_body(std::size_t index);
  void add_body(std::size_t index, const Samples& samples);
  void make_settings();
  void choose_solver(double dt);
  std::string automatic_solver(double dt);
  void count_solves(const StepReport& report);
  double expected_iterations(double dt) const;
  double weigh(const Work& work) const;
  MassKind inertia_mass() const { return {scene_.integrator.mass == "consistent", scene_.integrator.ghost_penalty}; }
  /// Finds what light_nodes_ ties; false where nothing is, or inertia holds them.
  bool tie_light_nodes(const StepChoice& choice);
  std::unique_ptr<StepControl> new_control() const;
  void make_control();
  Integrator<D>& integrator_of(const StepChoice& choice);
  StepChoice first_choice();
  void tell_control(StepOutcome outcome, StepReport& report);
  void build_plan_or_throw();
  std::vector<double> domain_edges() const;
  Attempt attempt(const StepChoice& choice, const std::atomic<bool>* cancel, StepReport& report);
  void grid_velocity(double dt, StepReport& report);
  void sharpen(const Vector& momentum, Vector& rate, StepReport& report);
  void grid_acceleration(bool carried, StepReport& report);
  void carry_acceleration();
  bool has_inertia(const StepChoice& choice) const;
  void tell_of_plan(StepReport& report);
  void tell_of_blend(const MassMatrix<D>& M, StepReport& report);
  Attempt judge(const NewtonResult& newton, const StepChoice& choice, StepReport& report);
  void keep_grid(const FeasibleSet<D>& set);
  /// For pictures of a state that no step led to.
  void show_grid_at_rest(const FeasibleSet<D>& set);
  void guess_friction(FeasibleSet<D>& set) const;
  void keep_friction(const FeasibleSet<D>& set);
  void fill_diagnostics(StepReport& report) const;
  /// Of a state that no step led to.
  void describe_state(StepReport& report);
  ParticleState state_of(std::size_t p) const;
  ParticleLook look_at_particle(std::uint32_t id) const;
  NodeLook look_at_node(const std::array<std::int32_t, 3>& index) const;
  void capture_fields(const SnapshotRequest& request, Snapshot& into) const;
  double plain_value(Field field, std::size_t p) const;
  void capture_stress(std::span<const Field> wanted, bool energy, Snapshot& into) const;
  void capture_node_fields(std::span<const Field> wanted, Snapshot& into) const;
  /// f_int of the state at hand, on the plan's nodes (THEORY T3).
  Vector internal_force() const;
  void capture_grid(Snapshot& into) const;
  double recent_stable_step() const;

  Scene scene_;
  mutable Parallel parallel_;
  Laws<D> laws_;
  std::unique_ptr<Transfer<D>> transfer_;
  std::unique_ptr<Integrator<D>> integrator_;
  std::unique_ptr<Integrator<D>> explicit_;  ///< adaptive control's other choice
  std::unique_ptr<StepControl> control_;
  std::unique_ptr<LinearSolver<D>> linear_;
  std::string chosen_solver_, choice_reason_;
  SolveCosts solves_;
  Conditions<D> conditions_;
  Loads<D> loads_;
  KnownMotion<D> known_;
  std::shared_ptr<SceneView> view_;

  Particles<D> particles_;
  Plan<D> plan_;
  GridState<D> grid_;
  LastGrid last_grid_;
  // Of one step; kept for their memory alone.
  FeasibleSet<D> set_;
  std::vector<HeldNode<D>> prescribed_;  ///< rates that transfers of more than one term hold
  Vector momentum_before_, momentum_after_;
  std::vector<RubbingNode<D>> rubbing_;  ///< of the last accepted step, by ascending index
  MassMemory<D> mass_memory_, velocity_mass_memory_;
  ElasticMemory elastic_memory_;  ///< tangents while a step is solved for, then what `moved_` points to
  Particles<D> other_;            ///< the same where steps are explicit
  Motion<D> moved_{};
  std::vector<Followed> probes_;

  /// The stable step that was worked out last; 0 s: none.
  struct StableStep {
    long step = 0;
    double seconds = 0;
  };
  mutable StableStep stable_;

  double time_ = 0, end_ = 0;
  double size_ = 0;  ///< of the largest body [m]
  bool told_of_blend_ = false, told_of_domains_ = false, told_of_edges_ = false;
  StepReport accepted_, returned_;
  RecordLevel recording_ = RecordLevel::none;
  std::shared_ptr<const StepRecord> record_;
  Work work_;

  Held held_;
  std::optional<Grab> grab_;
  double grab_stiffness_ = 0;

  bool ledger_ = false;
  double edited_energy_ = 0;          ///< what edits changed the energy by since the last step [J]
  std::uint32_t came_ = 0;            ///< particles that there have been: ids are below it
  GhostPenalty<D> light_nodes_;       ///< of a step without inertia
  std::vector<Mat<D>> domain_of_id_;  ///< of bodies that are fitted; empty where none is (Plan::Domains)
  std::shared_ptr<const std::vector<float>> domains_shown_;  ///< the same for snapshots
  StrokeSums strokes_;
  double stroked_energy_ = 0;            ///< what strokes changed since the last step [J]
  Vec3 stroked_angular_ = Vec3::Zero();  ///< [kg m^2/s]
};

}  // namespace pf
