#include "app/cli/pictures.hpp"

#include "app/record/film.hpp"
#include "core/build_info.hpp"
#include "core/files.hpp"
#include "core/scene/scene_io.hpp"
#include "render/picture.hpp"

namespace pf::app {

namespace {

pf::PictureOptions picture_options(const FrameOutput& output, const Scene& scene) {
  pf::PictureOptions options;
  options.size = {output.size.width, output.size.height};
  const ViewSettings& view = scene.view;
  if (const FieldInfo* field = find_field(view.color_by)) options.render.field = field->field;
  options.render.logarithmic = view.color_log;
  if (view.color_min && view.color_max) options.render.range = ValueRange{*view.color_min, *view.color_max};
  options.render.best_quality = true;
  options.title = scene.name;
  options.overlay = output.overlay;
  return options;
}

std::unique_ptr<PictureMaker> make_pictures(const pf::PictureOptions& options) {
  try {
    return std::make_unique<PictureMaker>(options);
  } catch (const std::runtime_error& error) {
    throw FileError(std::string("pictures cannot be drawn here: ") + error.what());
  }
}

}  // namespace

struct PictureWriter::Impl {
  FrameOutput output;
  ImageText text;  ///< the same in every picture
  std::unique_ptr<PictureMaker> maker;
  std::unique_ptr<Film> film;
  Snapshot snapshot;
};

PictureWriter::PictureWriter(const FrameOutput& output, const Scene& scene) : impl_(std::make_unique<Impl>()) {
  impl_->output = output;
  const BuildInfo build = build_info();
  impl_->text = {{"Software", "pushforward " + std::string(build.version)},
                 {"Commit", std::string(build.commit)},
                 {"Scene", scene.name},
                 {"Scene hash", scene_hash(scene)}};
  if (output.folder) make_folder(*output.folder);
  if (output.video)
    impl_->film = std::make_unique<Film>(*output.video, ViewSize{output.size.width, output.size.height},
                                         output.frames_per_second);
  impl_->maker = make_pictures(picture_options(output, scene));
}

PictureWriter::~PictureWriter() = default;

void PictureWriter::on_frame(const Simulation& simulation, long number) {
  simulation.capture(snapshot_request(impl_->maker->options().render), impl_->snapshot);
  const Image image = impl_->maker->draw(impl_->snapshot);
  if (impl_->output.folder) {
    ImageText text = impl_->text;
    std::string time;
    append_number(time, simulation.time());
    text.emplace_back("Time", time + " s");
    write_png(image, *impl_->output.folder / (file_number(number) + ".png"), text);
  }
  if (impl_->film) impl_->film->add(image);
}

void PictureWriter::on_end(const Simulation& /*simulation*/, const RunResult& /*result*/) {
  if (impl_->film) impl_->film->close();
}

}  // namespace pf::app
