// Principal stresses as crosses: a line along each principal direction, as long as the stress is large, red in tension
// and blue in compression. As many as can be told apart. Internal to render/.
#pragma once

#include <memory>

#include "render/ink.hpp"

namespace pf {

class CrossLayer {
 public:
  /// Where the options want them and the snapshot has Snapshot::stress.
  void draw(const Frame& frame, InkPrograms& ink);
  void invalidate();
  /// Length of the whole line of 1 Pa [px]; 0 when none was drawn.
  double pixels_per_pascal() const { return pixels_per_pascal_; }

 private:
  /// 2D: particles no nearer to each other than a cross is long. They keep their crosses, and carry them along, until
  /// the view has moved or been scaled by much: nothing flickers.
  void choose_flat(const Frame& frame);
  bool still_serves(const Frame& frame) const;
  /// 3D: in each square of the screen the foremost particle.
  void choose_foremost(const Frame& frame);
  void upload(const Frame& frame);

  Ink lines_;
  Anchor anchor_;
  DataKey key_;
  Camera camera_;
  ViewSize size_;
  std::vector<std::uint8_t> chosen_id_;  ///< 2D, by id
  std::vector<std::size_t> chosen_;      ///< particles
  const SceneView* scene_ = nullptr;
  Vec3 chosen_origin_ = Vec3::Zero();
  double chosen_scale_ = 0;  ///< [px/m]
  double reference_ = 0;     ///< stress of a line of full length: the 85th percentile, falling slowly [Pa]
  double pixels_per_pascal_ = 0;
};

/// Colours of tension and compression.
Color tension_color(const RenderTheme& theme);
Color compression_color(const RenderTheme& theme);

}  // namespace pf
