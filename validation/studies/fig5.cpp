#include <cmath>

#include <fairlight/stats/text.h>
#include <fairlight/validation/studies/all_studies.h>
#include <fairlight/validation/studies/closed_forms.h>
#include <fairlight/validation/studies/confusion.h>
#include <fairlight/validation/studies/pictures.h>
#include <fairlight/validation/studies/renders.h>
#include <fairlight/validation/studies/scenes.h>

namespace fairlight::studies_of_paper {
namespace {

struct Factor {
  double value;
  const char* name;
};
constexpr Factor factors[]{{0.25, "1/4"}, {0.5, "1/2"}, {1, "1"}, {2, "2"}, {4, "4"}};

constexpr double lens_radius = 6, focus = 232;  // the ball on the right

// The camera of the box, with its field of view or its lens scaled.
View box_through(double field_factor, double lens) {
  View box = box_with_light(1.5);
  CameraSettings camera = box.camera.settings();
  camera.start = 0;
  camera.image_height *= field_factor;
  camera.aperture_radius = lens;
  camera.focus_distance = focus;
  box.camera = Camera(camera);
  return box;
}

RenderSettings settings_of(int size) {
  RenderSettings settings;
  settings.width = settings.height = size;
  settings.light_sampling = LightPoints::cone;
  settings.roulette = RouletteKind::throughput;
  return settings;
}

// A ball that emits 1 and nothing else: the mean of the picture is the part that the ball fills.
View lone_ball(double field_factor) {
  CameraSettings camera{.eye = {0, 0, 0}, .look = {0, 0, -1}, .image_height = 0.5135 * field_factor};
  Scene scene;
  scene.add_sphere({0.5, 0.7, -100}, 5, Rgb<double>(0, 0, 0), Rgb<double>(1, 1, 1));
  return {"ball", scene, Camera(camera)};
}

StudyTable fields(const StudyOptions& options, Steps& steps) {
  StudyTable table{
      "fields",
      "The part of the picture that a ball of 5 m at about 100 m fills, with an image plane 1/4 to 4 times as "
      "high as the paper's.",
      {{"factor"}, {"field of view in degrees"}, {"part of the picture"}, {"closed form"}},
      {}};
  const double distance = Vec3<double>(0.5, 0.7, -100).norm();
  RenderSettings settings = settings_of(64);
  settings.direct = DirectLighting::none;
  for (const auto& [factor, name] : factors) {
    const View view = lone_ball(factor);
    const double height = view.camera.settings().image_height;
    std::vector<double> parts;
    const std::vector<bool> all(64 * 64, true);
    for (std::uint32_t replicate = 0; replicate < 10; ++replicate) {
      const Arm arm{formatted("fig5 field %s", name), view, settings, options.quick ? 16u : 256u};
      parts.push_back(mean_radiance(render_arm(arm, options, replicate).film, all).mean());
    }
    const double closed =
        closed_forms::sphere_picture_area(std::asin(5 / distance), std::acos(100 / distance)) / (height * height);
    table.rows.push_back({name, 360 / std::numbers::pi * std::atan(height / 2), measured_mean(parts), closed});
    steps.done();
  }
  return table;
}

StudyTable apertures(const StudyOptions& options, Steps& steps) {
  StudyTable table{
      "apertures",
      formatted("Radius of the circle of confusion in pixels of a picture 256 high, for a lens of %g m times "
                "the factor that is focused at %g m. The back wall is at 294 m.",
                lens_radius, focus),
      {{"factor"}, {"at 150 m"}, {"closed form"}, {"at 294 m"}, {"closed form"}},
      {}};
  for (const auto& [factor, name] : factors) {
    const CameraSettings camera = box_through(1, lens_radius * factor).camera.settings();
    const auto measured = [&](double at) {
      return measured_confusion(camera, at, 256, options, formatted("fig5 aperture %s %g", name, at));
    };
    table.rows.push_back({name, measured(150), circle_of_confusion(camera, 150, 256), measured(294),
                          circle_of_confusion(camera, 294, 256)});
    steps.done();
  }
  return table;
}

StudyPicture pictures(const StudyOptions& options, Steps& steps) {
  std::vector<Captioned> shown;
  for (const bool of_field : {true, false}) {
    for (const auto& [factor, name] : factors) {
      const View view = of_field ? box_through(factor, 0) : box_through(1, lens_radius * factor);
      const Arm arm{"fig5 picture", view, settings_of(options.quick ? 128 : 192), options.quick ? 16u : 256u};
      shown.push_back({render_arm(arm, options, 0).film, formatted("%s x %s", of_field ? "field" : "lens", name)});
      steps.done();
    }
  }
  return write_montage(
      options, "fig5",
      formatted("Above, image planes 1/4 to 4 times as high, as in the paper's figure. Below, a lens of %g m "
                "times 1/4 to 4, focused on the ball on the right: the field of view stays.",
                lens_radius),
      shown, 5);
}

}  // namespace

StudyResult fig5(const StudyOptions& options) {
  Steps steps(options, 20);
  StudyResult result;
  result.text =
      "What the paper calls the size of the aperture is, in its figure, the height of the image plane: it changes "
      "the field "
      "of view. The aperture of a lens changes what is blurred, and not the field of view. Both are measured "
      "against their "
      "closed forms.";
  result.tables.push_back(fields(options, steps));
  result.tables.push_back(apertures(options, steps));
  result.pictures.push_back(pictures(options, steps));
  return result;
}

}  // namespace fairlight::studies_of_paper
