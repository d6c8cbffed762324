#include "render/picture.hpp"

#include <algorithm>
#include <optional>

#include "core/charts/png_painter.hpp"
#include "render/offscreen.hpp"
#include "render/overlay.hpp"

namespace pf {

namespace {
/// Text and lines keep their share of the picture, within reason.
float scale_of(ViewSize size) {
  return std::clamp(static_cast<float>(std::min(size.height / 720.0, size.width / 1000.0)), 0.75f, 6.f);
}
}  // namespace

struct PictureMaker::Impl {
  PictureOptions options;
  OffscreenContext context;
  Renderer renderer;
  OffscreenTarget target;
  std::optional<Camera> camera;    ///< set by the caller
  std::optional<ViewBounds> seen;  ///< else: what all pictures until now had to show
  double first_size = 0;

  explicit Impl(const PictureOptions& wanted) : options(wanted), target(wanted.size, 4) {
    options.render.pixel_scale = scale_of(options.size);
    options.render.best_quality = true;
  }

  Camera follow(const Snapshot& snapshot) {
    if (!seen) {
      seen = scene_bounds(snapshot);
      first_size = seen->size().maxCoeff();
    }
    seen = widened(*seen, particle_bounds(snapshot), first_size);
    return picture_camera(snapshot.dimension, *seen, options.size, options.overlay);
  }
};

PictureMaker::PictureMaker(const PictureOptions& options) : impl_(std::make_unique<Impl>(options)) {}
PictureMaker::~PictureMaker() {
  impl_->context.make_current();  // its objects are deleted in it
}

PictureOptions& PictureMaker::options() {
  return impl_->options;
}
void PictureMaker::set_camera(const Camera& camera) {
  impl_->camera = camera;
}

Image PictureMaker::draw(const Snapshot& snapshot) {
  Impl& im = *impl_;
  im.context.make_current();
  const ViewSize size = im.target.size();
  const Camera camera = im.camera ? *im.camera : im.follow(snapshot);
  im.target.bind();
  im.renderer.draw(snapshot, im.options.render, camera, {0, 0, size});
  Image image = im.target.read();
  if (!im.options.overlay) return image;
  OverlayInfo info = OverlayInfo::of(snapshot, im.renderer, im.options.render, camera, size);
  info.title = im.options.title;
  const float scale = im.options.render.pixel_scale;
  PngPainter painter(image, scale);
  draw_overlay(info, im.options.render.theme, painter, {0, 0},
               {static_cast<float>(size.width) / scale, static_cast<float>(size.height) / scale});
  return image;
}

Camera picture_camera(int dimension, const ViewBounds& bounds, ViewSize size, bool overlay) {
  const double scale = scale_of(size);
  ViewMargins margins =
      overlay ? overlay_margins(dimension, size.width / scale, size.height / scale) : ViewMargins{24, 24, 24, 24};
  margins = settled(margins.scaled(scale, scale), fitted_camera(dimension, bounds, size), bounds, size);
  return fitted_camera(dimension, bounds, size, margins);
}

Camera picture_camera(const Snapshot& first, ViewSize size, bool overlay) {
  return picture_camera(first.dimension, scene_bounds(first), size, overlay);
}

Image draw_picture(const Snapshot& snapshot, const PictureOptions& options) {
  PictureMaker maker(options);
  return maker.draw(snapshot);
}

SnapshotRequest snapshot_request(const RenderOptions& options) {
  SnapshotRequest request;
  request.fields = field_bit(options.field);
  request.grid = options.grid || options.velocities || options.bent_grid || field_info(options.field).on_nodes;
  request.stress = options.stress_crosses;
  return request;
}

}  // namespace pf
