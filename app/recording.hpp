// What a live session changed, as edits that a scene file can carry.
#pragma once

#include <vector>

#include "core/params/setting.hpp"
#include "core/scene/scene.hpp"

namespace pf::app {

/// The edits that turn `from` into `to`, as deep in the document as its structure allows: edited(from, ...) equals
/// `to`. Arrays of another length are replaced whole.
std::vector<Edit> difference(const Scene& from, const Scene& to);

/// When an edit takes effect: that of its setting or of the nearest setting above it; `reset` when none is known
/// or when it changes an object that holds a setting that needs a reset.
Applies applies(const Edit& edit);

/// Those of `edits` that take effect as `when` says.
std::vector<Edit> only(const std::vector<Edit>& edits, Applies when);

/// A live session: the scene that was built, and what was changed at which time.
class Recording {
 public:
  void begin(const Scene& built) {
    built_ = built;
    log_.clear();
    grabbed_ = false;
  }
  /// `edits` were applied to the state at `time` [s]. Those of one state become one event.
  void add(double time, const std::vector<Edit>& edits);
  /// The mouse pulled at the material: no event can say that.
  void note_grab() { grabbed_ = true; }
  bool grabbed() const { return grabbed_; }
  /// The built scene with the log added to its events, ordered by time.
  Scene scene() const;

 private:
  Scene built_;
  std::vector<Event> log_;
  bool grabbed_ = false;
};

}  // namespace pf::app
