#include <algorithm>
#include <atomic>

#include <fairlight/render/instruction_sets.h>
#include <fairlight/render/parallel.h>
#include <fairlight/render/render_image.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

constexpr int tile_size = 16;

std::vector<Tile> tiles(int width, int height) {
  std::vector<Tile> all;
  for (int top = 0; top < height; top += tile_size) {
    for (int left = 0; left < width; left += tile_size) {
      all.push_back({left, top, std::min(left + tile_size, width), std::min(top + tile_size, height)});
    }
  }
  return all;
}

bool absorbs_nothing(const Surface& surface) {
  return surface.material.kind == Material::Kind::glass || surface.material.albedo.maxCoeff() == 1;
}

// The largest radius of a pixel filter, in pixels.
constexpr double widest_filter = 2;

// Without a depth limit, throws if rays may start in a sphere from which a path need not escape: a
// glass sphere, by internal reflection, or any sphere if no surface of the scene absorbs light.
void check_camera(const View& view, const Strategies& strategies, const Film& film) {
  if (strategies.max_depth >= 0) return;
  const double height = film.height(), around = 2 * widest_filter / height;
  const std::vector<Surface>& surfaces = view.scene.surfaces();
  const bool all_white = std::ranges::all_of(surfaces, absorbs_nothing);
  for (const Surface& surface : surfaces) {
    const bool keeps_light = surface.material.kind == Material::Kind::glass || all_white;
    if (!keeps_light || surface.rectangle) continue;
    const double radius = 1 / surface.shape.curvature;
    const Vec3<double> centre = surface.shape.anchor - radius * surface.shape.normal;
    if (view.camera.distance_to_starts(centre, film.width() / height + around, 1 + around) < radius)
      throw std::invalid_argument(
          "the camera, or a part of its view, is inside a sphere that absorbs nothing, and a path need not end "
          "(give --max-depth)");
  }
}

}  // namespace

View view_of(const RenderSettings& settings) { return with_camera_of(settings, built_in_scene(settings.scene)); }

View with_camera_of(const RenderSettings& settings, View view) {
  check_finite(settings);
  CameraSettings camera = view.camera.settings();
  if (settings.aperture >= 0) camera.aperture_radius = settings.aperture;
  if (settings.focus >= 0) camera.focus_distance = settings.focus;
  if (settings.fov >= 0) camera.image_height = image_height_of(settings.fov);
  view.camera = Camera(camera);
  return view;
}

void check_whole_sets(const RenderSettings& settings, std::uint64_t samples) {
  const std::uint64_t rest = samples % SampleSets(settings.points).size();
  if (rest == 0) return;
  const std::string fewer = samples == rest ? "" : std::to_string(samples - rest) + " or ";
  throw std::invalid_argument(std::to_string(samples) + " samples are no whole sets of " +
                              std::to_string(settings.points) + " points (give --spp " + fewer +
                              std::to_string(samples - rest + settings.points) + ", or --points)");
}

RenderCost render_image(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                        int threads, Film& film, const Progress& progress, const std::string& instructions) {
  check_finite(settings);
  const Strategies strategies(settings, view.scene);
  check_camera(view, strategies, film);
  if (settings.real == Arithmetic::packets) {
    require_floats(view.scene);
    view.camera.require_rays<float>();
  } else {
    view.camera.require_rays<double>();
  }
  check_whole_sets(settings, range.first);
  check_whole_sets(settings, range.last);
  const TileSettings tiled{view.scene,   view.camera,
                           strategies,   StreamKey(seed, formatted("render %s", name_of(settings.random))),
                           film.width(), film.height()};
  const auto renderer = tile_renderer(settings.real, choose_instructions(instructions), tiled);
  const std::vector<Tile> units = tiles(film.width(), film.height());
  RenderCost cost;
  std::atomic<std::uint64_t> rays = 0;
  for_each_unit(
      units.size(), threads, [&](std::size_t unit) { rays += renderer->render(units[unit], range, film); },
      progress);
  cost.rays = rays;
  cost.paths = static_cast<std::uint64_t>(film.width()) * static_cast<std::uint64_t>(film.height()) *
               (range.last - range.first);
  return cost;
}

}  // namespace fairlight
