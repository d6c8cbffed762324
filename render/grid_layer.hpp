// The background grid in the last step: active cells and nodes, node velocities, the grid bent by phi^. Internal
// to render/.
#pragma once

#include "render/ink.hpp"

namespace pf {

class GridLayer {
 public:
  GridLayer();
  /// Below the particles (2D): tint of the cells that hold particles.
  void draw_cells(const Frame& frame);
  /// Above the particles: bent grid lines, nodes, velocity arrows, as the options say.
  void draw(const Frame& frame, InkPrograms& ink);
  void invalidate();
  double arrow_pixels_per_speed() const { return arrow_scale_; }

 private:
  void upload_cells(const Frame& frame);
  void upload_nodes(const Frame& frame);
  void upload_arrows(const Frame& frame);
  void upload_bent(const Frame& frame);

  Program cell_program_{"cell2d"};
  gl::Batch cells_;
  Ink nodes_, arrows_, bent_;
  Anchor cell_anchor_, node_anchor_, arrow_anchor_, bent_anchor_;
  ValueRange node_range_;  ///< of their colours
  DataKey cell_key_, node_key_, arrow_key_, bent_key_;
  double reference_speed_ = 0;  ///< 95th percentile of node speeds, falling slowly [m/s]
  double arrow_scale_ = 0;      ///< [px s/m]
};

}  // namespace pf
