// What a live session changed, as edits that a scene file can carry.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/params/setting.hpp"
#include "core/scene/scene.hpp"
#include "core/simulation.hpp"

namespace pf::app {

/// The edits that turn `from` into `to`, as deep in the document as its structure allows: edited(from, ...) equals
/// `to`. Arrays that have
/// grown are appended to ("/bodies/-"), others of another length replaced whole.
std::vector<Edit> difference(const Scene& from, const Scene& to);

/// When an edit takes effect: that of its setting or of the nearest setting above it; `reset` when none is known
/// or when it changes an object that holds a setting that needs a reset.
Applies applies(const Edit& edit);

/// Those of `edits` that take effect as `when` says.
std::vector<Edit> only(const std::vector<Edit>& edits, Applies when);

/// What was done to one state of a run: settings changed, or its end, or particles were cut or painted, or the mouse
/// took hold, pulled on or let go.
struct Deed {
  long step = 0;    ///< of the state
  double time = 0;  ///< of the state [s]
  std::vector<Edit> edits = {};
  bool hold = false;  ///< it is the mouse's, and `grab` is what it does from there on
  std::optional<Grab> grab = {};
  std::optional<Stroke> stroke = {};
  std::uint64_t gesture = 0;       ///< strokes of one drag of the mouse have the same
  std::optional<double> end = {};  ///< from there on the run ends at this time [s]
};

/// A live session: the scene that was built, and what was done at which state.
class Recording {
 public:
  void begin(const Scene& built) {
    built_ = built;
    deeds_.clear();
    taken_back_.clear();
  }
  /// Probes are the same all along.
  void set_probes(const std::vector<Probe>& probes) { built_.probes = probes; }
  /// `edits` were applied to the state after `step`, at `time` [s].
  void add(long step, double time, const std::vector<Edit>& edits);
  /// From this state on the mouse does that.
  void add_grab(long step, double time, const std::optional<Grab>& grab);
  /// This was cut or painted there.
  void add_stroke(long step, double time, const Stroke& stroke, std::uint64_t gesture) {
    push({.step = step, .time = time, .stroke = stroke, .gesture = gesture});
  }
  /// The last thing that was done is a stroke.
  bool ends_in_stroke() const { return !deeds_.empty() && deeds_.back().stroke; }
  /// Forgets the strokes of the gesture that it ends in; the first of them. Nothing where it does not end in one.
  std::optional<Deed> take_back_strokes();
  /// Strokes were taken back, and nothing was done since.
  bool can_bring_back() const { return !taken_back_.empty(); }
  /// Remembers the strokes again that were taken back last: the steps of the first and of the last of them.
  std::optional<std::pair<long, long>> bring_back_strokes();
  /// From this state on the run ends at `end`: the last step is as long as that leaves.
  void add_end(long step, double time, double end) { push({.step = step, .time = time, .end = end}); }
  /// Another run begins at the state after `step`: what was done to later ones is forgotten.
  void forget_after(long step);
  /// In the order in which it was done.
  const std::vector<Deed>& deeds() const { return deeds_; }
  /// The mouse pulled at the material: no event can say that.
  bool grabbed() const;
  /// The built scene with what was edited added to its events, ordered by time.
  Scene scene() const;

 private:
  /// What is done now comes in the place of what was taken back.
  void push(Deed deed) {
    taken_back_.clear();
    deeds_.push_back(std::move(deed));
  }

  Scene built_;
  std::vector<Deed> deeds_;
  std::vector<std::vector<Deed>> taken_back_;  ///< gestures, the one that was taken back last at the end
};

}  // namespace pf::app
