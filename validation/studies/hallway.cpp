#include <cmath>

#include <fairlight/stats/text.h>
#include <fairlight/validation/studies/all_studies.h>
#include <fairlight/validation/studies/confusion.h>
#include <fairlight/validation/studies/pictures.h>
#include <fairlight/validation/studies/renders.h>

/// The studies of Figs. 6 and 7: one hallway, two apertures.
namespace fairlight::studies_of_paper {
namespace {

constexpr int balls[]{0, 2, 4};  // in focus, counted from the front

Vec3<double> ball(int i) { return {-14.0 + 4.5 * i, 8, 40.0 - 40 * i}; }  // as in hallway()

CameraSettings focused_on(int i, double aperture) {
  CameraSettings camera = hallway().camera.settings();
  camera.aperture_radius = aperture;
  camera.focus_distance = seen_at(camera, ball(i), 1, 1).distance;
  return camera;
}

StudyTable confusion(const StudyOptions& options, const std::string& name, double aperture) {
  StudyTable table{
      "confusion",
      formatted("Radius of the circle of confusion of each ball's middle, in pixels of a picture 256 high, "
                "for a lens of %g m. In focus it is 0, and what is measured is rounding.",
                aperture),
      {{"ball"}, {"distance in m"}},
      {}};
  for (const int focus : balls) {
    table.columns.push_back({formatted("focus at %.0f m", focused_on(focus, aperture).focus_distance)});
    table.columns.push_back({"closed form"});
  }
  for (int i = 0; i < 7; ++i) {
    std::vector<Cell> row{static_cast<double>(i + 1), seen_at(focused_on(0, aperture), ball(i), 1, 1).distance};
    for (const int focus : balls) {
      const CameraSettings camera = focused_on(focus, aperture);
      const double distance = seen_at(camera, ball(i), 1, 1).distance;
      row.emplace_back(
          measured_confusion(camera, distance, 256, options, formatted("%s %d %d", name.c_str(), i, focus)));
      row.emplace_back(circle_of_confusion(camera, distance, 256));
    }
    table.rows.push_back(row);
  }
  return table;
}

// The circles, as gnuplot objects on the sheet.
std::string circles(const CameraSettings& camera, int picture, int size) {
  std::string script;
  const auto [left, top] = place_on_sheet(picture, 3, size, size);
  for (int i = 0; i < 7; ++i) {
    const auto [x, y, distance] = seen_at(camera, ball(i), size, size);
    script +=
        formatted("set object circle at %.2f,%.2f size first %.3f front fs empty border rgb '#ffd200' lw 1.5\n",
                  left + x, top + y, circle_of_confusion(camera, distance, size));
  }
  return script;
}

StudyResult in_hallway(const StudyOptions& options, const std::string& name, double aperture,
                       const std::string& text) {
  Steps steps(options, 4);
  StudyResult result;
  result.text = text;
  result.tables.push_back(confusion(options, name, aperture));
  steps.done();
  std::vector<Captioned> shown;
  std::string overlay;
  const int size = options.quick ? 160 : 256;
  for (int k = 0; k < 3; ++k) {
    View view = hallway();
    const CameraSettings camera = focused_on(balls[k], aperture);
    view.camera = Camera(camera);
    RenderSettings settings;
    settings.width = settings.height = size;
    settings.light_sampling = LightPoints::cone;
    settings.which_light = WhichLight::contribution;
    settings.roulette = RouletteKind::throughput;
    const Film film = render_arm({name, view, settings, options.quick ? 16u : 512u}, options, 0).film;
    shown.push_back({film, formatted("focus on ball %d, at %.0f m", balls[k] + 1, camera.focus_distance)});
    overlay += circles(camera, k, size);
    steps.done();
  }
  result.pictures.push_back(
      write_montage(options, name,
                    formatted("A lens of %g m. The yellow circles are the circles of confusion of "
                              "the balls' middles, to scale.",
                              aperture),
                    shown, 3, overlay));
  return result;
}

}  // namespace

StudyResult fig6(const StudyOptions& options) {
  return in_hallway(
      options, "fig6", 5,
      "A large aperture has a shallow depth of field: one ball is sharp, and the others blur the more the "
      "further they are from the focus.");
}

StudyResult fig7(const StudyOptions& options) {
  return in_hallway(
      options, "fig7", 1.25,
      "With a quarter of the aperture of Fig. 6 every circle of confusion is a quarter as wide, and more of "
      "the hallway is sharp.");
}

}  // namespace fairlight::studies_of_paper
