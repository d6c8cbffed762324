// Undo and redo of scene edits.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.hpp"

namespace pf::app {

/// What an edit changes, and whose edit it is.
struct Document {
  Scene scene;
  std::filesystem::path file;  ///< empty: not saved yet
  std::uint64_t number = 0;    ///< another number, another scene
};

class UndoStack {
 public:
  using Clock = std::chrono::steady_clock;

  void clear() {
    past_.clear();
    future_.clear();
    last_.clear();
  }
  /// `before` is about to be changed by `edits`. Edits of one place in quick succession (a dragged slider) are
  /// one step back; no edits: it is replaced as a whole, a step of its own.
  void push(const Document& before, const std::vector<Edit>& edits, Clock::time_point now = Clock::now()) {
    std::string places;
    for (const Edit& edit : edits) places += edit.pointer + "\n";
    const bool same_gesture = !past_.empty() && !edits.empty() && places == last_ && now - when_ < gesture &&
                              std::all_of(edits.begin(), edits.end(), [](const Edit& e) { return is_value(e.value); });
    last_ = places;
    when_ = now;
    future_.clear();
    if (same_gesture) return;
    past_.push_back(before);
    if (past_.size() > most) past_.erase(past_.begin());
  }
  bool can_undo() const { return !past_.empty(); }
  bool can_redo() const { return !future_.empty(); }
  /// What was before the newest edit, or nothing. `now` becomes what redo() gives back.
  std::optional<Document> undo(const Document& now) { return move(past_, future_, now); }
  std::optional<Document> redo(const Document& now) { return move(future_, past_, now); }

 private:
  static constexpr std::chrono::milliseconds gesture{700};
  static constexpr std::size_t most = 200;

  /// Of a slider or a field: things that come and go are each a step of their own.
  static bool is_value(const nlohmann::json& json) {
    return json.is_primitive() ||
           (json.is_array() &&
            std::all_of(json.begin(), json.end(), [](const nlohmann::json& j) { return j.is_primitive(); }));
  }

  std::optional<Document> move(std::vector<Document>& from, std::vector<Document>& to, const Document& now) {
    last_.clear();
    if (from.empty()) return std::nullopt;
    to.push_back(now);
    Document before = std::move(from.back());
    from.pop_back();
    return before;
  }

  std::vector<Document> past_, future_;
  std::string last_;
  Clock::time_point when_{};
};

}  // namespace pf::app
