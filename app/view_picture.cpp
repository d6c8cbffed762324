// Pictures of the view, for files.
#include <algorithm>
#include <cmath>

#include "app/gl_view.hpp"
#include "core/charts/png_painter.hpp"
#include "render/overlay.hpp"

namespace pf::app {

namespace {

ViewSize picture_size(const PictureRequest& request, ViewSize view) {
  if (request.size.width > 0) return request.size;
  const double finer = request.as_view ? 1 : std::max(1.0, 1600.0 / view.width);
  const auto more = [&](int pixels) { return static_cast<int>(std::lround(finer * pixels)); };
  return {more(view.width), more(view.height)};
}

}  // namespace

Camera GlView::picture_camera(ViewSize picture, const ViewMargins& margins, double scale) const {
  Camera camera = camera_;
  if (follow_size_) {
    const ViewMargins pixels = settled(margins.scaled(scale, scale), camera, fitted_, picture);
    std::visit([&](auto& c) { c.fit(fitted_, picture, pixels); }, camera);
    return camera;
  }
  const double finer =
      std::min(static_cast<double>(picture.width) / size_.width, static_cast<double>(picture.height) / size_.height);
  if (auto* flat = std::get_if<Camera2D>(&camera)) {
    flat->pixels_per_metre *= finer;
  } else {
    auto& orbit = std::get<OrbitCamera>(camera);
    orbit.distance *= static_cast<double>(picture.height) / size_.height / finer;
  }
  return camera;
}

const std::vector<float>& GlView::counts(const AppContext& context, const OverlayInfo& info) {
  constexpr int bins = 48;
  const Counted wanted{context.snapshot, info.field, info.scale, info.range};
  if (wanted == counted_) return counts_;
  counted_ = wanted;
  counts_.clear();
  const auto& values = context.snapshot->field[static_cast<std::size_t>(info.field)];
  if (info.scale != ColorScale::categorical && !values.empty() && info.range.max > info.range.min)
    counts_ = histogram(values, info.range, info.scale, bins);
  return counts_;
}

Image GlView::picture(const AppContext& context, const PictureRequest& request) {
  const ViewSize size = picture_size(request, size_);
  const double finer =
      std::min(static_cast<double>(size.width) / size_.width, static_cast<double>(size.height) / size_.height);
  RenderOptions options = render_options(context, static_cast<float>(finer) * pixels_per_unit_ * overlay_scale());
  const auto scale = static_cast<double>(options.pixel_scale);
  const Camera camera =
      picture_camera(size, overlay_margins(dimension_, size.width / scale, size.height / scale), scale);
  options.best_quality = true;
  options.transparent = request.transparent;
  options.selected.reset();
  OffscreenTarget target(size);
  target.bind();
  renderer_.draw(*context.snapshot, options, camera, {0, 0, size});
  Image image = target.read();
  if (request.transparent) image.unpremultiply();
  if (!request.overlay) return image;
  OverlayInfo info = OverlayInfo::of(*context.snapshot, renderer_, options, camera, size);
  info.title = context.scene.name;
  if (context.view.show_histogram) info.histogram = counts(context, info);
  PngPainter painter(image, options.pixel_scale);
  pf::draw_overlay(
      info, options.theme, painter, {0, 0},
      {static_cast<float>(size.width) / options.pixel_scale, static_cast<float>(size.height) / options.pixel_scale});
  return image;
}

}  // namespace pf::app
