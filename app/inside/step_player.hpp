// One step, played slowly (THEORY T3 to T5): particles give mass and velocity to the nodes, each Newton iterate bends
// the grid, particles ride, the grid snaps back. What is shown are the numbers of a real step (core/step_record.hpp).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session.hpp"
#include "core/scene/scene.hpp"

namespace pf::app {

enum class PhaseKind {
  give,         ///< particles give mass and momentum to the nodes
  guess,        ///< the grid goes to where the minimisation starts
  iterate,      ///< one Newton iteration
  kick,         ///< an explicit step: forces at the start move the grid
  extrapolate,  ///< from a stage's end to the step's
  ride,         ///< particles ride on the bent grid
  snap          ///< the grid goes back to its place
};

struct Phase {
  PhaseKind kind;
  std::size_t iterate = 0;  ///< into StepRecord::iterates: where it ends
  double seconds = 2;       ///< at speed 1
  std::string title, brief;
};

class StepPlayer {
 public:
  /// `scene`: as it was when the step was made.
  StepPlayer(ApartStep step, Scene scene);

  const std::vector<Phase>& phases() const { return phases_; }
  const StepRecord& record() const { return *step_.record; }
  const Scene& scene() const { return scene_; }

  /// Whole numbers are the beginnings of phases; up to phases().size().
  double position() const { return position_; }
  std::size_t phase_index() const;
  const Phase& phase() const { return phases_[phase_index()]; }
  /// How far the phase's motion has come, 0 to 1, slow at both ends.
  double motion() const;
  void seek(double position);
  /// To the beginning of the next phase or of this one (of the one before, at its beginning).
  void next();
  void previous();
  bool at_end() const { return position_ >= static_cast<double>(phases_.size()); }

  bool playing = true;
  double speed = 1;
  /// As time goes by; stops at the end.
  void advance(double seconds);

  /// Motions are drawn this many times as large, so that they are seen; 1, 2, 5, 10, ...
  double magnification() const { return magnification_; }
  void set_magnification(double times) { magnification_ = times; }

  /// What the view shows at this position. The same object until the position or the magnification changes.
  std::shared_ptr<const Snapshot> snapshot();

  /// Whether the picture has a node: not those that hold next to nothing, below a hundredth of the heaviest, which go
  /// wherever their few grams are thrown.
  bool draws(std::size_t node) const { return drawn_[node]; }
  /// Displacement of a node at this position [m], not magnified.
  Vec3 node_displacement(std::size_t node) const;
  std::optional<std::size_t> find_node(const NodeIndex& index) const;
  NodeIndex node(std::size_t node) const;
  /// Where in the record's arrays a particle stands.
  std::optional<std::size_t> find_particle(std::uint32_t id) const;
  /// A particle worth watching: near the node with most of the first residual, else one in the middle of the body.
  std::uint32_t remarkable_particle() const;

 private:
  void make_phases();
  /// Grid displacements at the beginning and the end of the current phase; null: none.
  std::pair<const std::vector<double>*, const std::vector<double>*> displacements() const;

  void fill_grid(Snapshot& snapshot) const;

  ApartStep step_;
  Scene scene_;
  std::vector<bool> drawn_;  ///< one a node
  std::vector<Phase> phases_;
  double position_ = 0, magnification_ = 1;
  std::shared_ptr<const Snapshot> shown_;
  double shown_position_ = -1, shown_magnification_ = 0;
};

/// Components of entry k of an interleaved array; z = 0 in 2D.
Vec3 entry(const std::vector<double>& values, std::size_t k, int dimension);

}  // namespace pf::app
