// One call from a snapshot to a finished picture, without a display: `run --images` and the pictures of the
// documentation.
#pragma once

#include <memory>
#include <string>

#include "core/charts/image.hpp"
#include "core/snapshot.hpp"
#include "render/camera.hpp"
#include "render/renderer.hpp"

namespace pf {

struct PictureOptions {
  ViewSize size{1280, 720};
  RenderOptions render;  ///< pixel_scale is set from the size: line widths and text follow a height of 720
  bool overlay = true;
  std::string title;
};

/// Draws pictures of one run: keeps its off-screen context, its buffers and the colour range's memory.
class PictureMaker {
 public:
  /// Throws std::runtime_error, saying why, where no off-screen context can be had.
  explicit PictureMaker(const PictureOptions& options);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  /// May be changed between pictures, all but the size.
  PictureOptions& options();
  /// Seen through the camera set last; else through picture_camera() of the first snapshot given, widened where
  /// bodies leave it (to at most three times its size).
  Image draw(const Snapshot& snapshot);
  void set_camera(const Camera& camera);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The view that a run's pictures share, chosen from its first state: all of scene_bounds(), clear of the overlay.
Camera picture_camera(const Snapshot& first, ViewSize size, bool overlay = true);
/// The same for given bounds.
Camera picture_camera(int dimension, const ViewBounds& bounds, ViewSize size, bool overlay = true);

/// A single picture.
Image draw_picture(const Snapshot& snapshot, const PictureOptions& options = {});

/// What a snapshot must hold for `options` to be drawn.
SnapshotRequest snapshot_request(const RenderOptions& options);

}  // namespace pf
