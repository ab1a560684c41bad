#include <algorithm>
#include <mutex>
#include <stdexcept>

#include <fairlight/estimators/filter.h>
#include <fairlight/estimators/stream.h>
#include <fairlight/render/parallel.h>
#include <fairlight/render/path_tracer.h>
#include <fairlight/render/render_image.h>

namespace fairlight {
namespace {

constexpr int tile_size = 16;

// A scene that counts the rays it is asked about.
class CountedScene {
 public:
  explicit CountedScene(const Scene& scene) : scene_(scene) {}
  const auto& surfaces() const { return scene_.surfaces(); }
  const auto& luminaires() const { return scene_.luminaires(); }
  auto intersect(const Ray<double>& ray) const {
    ++rays_;
    return scene_.intersect(ray);
  }
  bool visible(const Ray<double>& ray, double distance, int target) const {
    ++rays_;
    return scene_.visible(ray, distance, target);
  }
  std::uint64_t rays() const { return rays_; }

 private:
  const Scene& scene_;
  mutable std::uint64_t rays_ = 0;
};

struct Tile {
  int left, top, right, bottom;
};

std::vector<Tile> tiles(int width, int height) {
  std::vector<Tile> all;
  for (int top = 0; top < height; top += tile_size) {
    for (int left = 0; left < width; left += tile_size) {
      all.push_back({left, top, std::min(left + tile_size, width), std::min(top + tile_size, height)});
    }
  }
  return all;
}

template <class Tracer>
std::uint64_t render_tile(const View& view, const Tracer& tracer, const StreamKey& key, const Tile& tile,
                          SampleRange range, Film& film) {
  const CountedScene scene(view.scene);
  const TentFilter<double> filter;
  for (int y = tile.top; y < tile.bottom; ++y) {
    for (int x = tile.left; x < tile.right; ++x) {
      const auto pixel =
          static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(film.width()) + static_cast<std::uint32_t>(x);
      for (std::uint64_t sample = range.first; sample < range.last; ++sample) {
        PhiloxStream<double> source(key, pixel, sample);
        const Ray<double> ray = pixel_ray(view.camera, filter, x, y, film.width(), film.height(), source);
        film.add(x, y, tracer.template radiance<double>(scene, ray, source));
      }
    }
  }
  return scene.rays();
}

[[noreturn]] void refuse(const char* strategy, const std::string& value) {
  throw std::invalid_argument(std::string("there is no ") + strategy + " \"" + value +
                              "\" (see fairlight render --help)");
}

template <template <class> class Directions, class Direct>
void with_roulette(const RenderSettings& settings, const auto& render) {
  if (settings.roulette == "albedo") {
    return render(PathTracer<Directions, Direct, RouletteByReflectance<>>(settings.max_depth));
  }
  if (settings.roulette == "off") return render(PathTracer<Directions, Direct, NoRoulette>(settings.max_depth));
  refuse("roulette", settings.roulette);
}

template <template <class> class Directions>
void with_direct(const RenderSettings& settings, const auto& render) {
  if (settings.direct == "none") return with_roulette<Directions, NoDirectLight>(settings, render);
  if (settings.direct != "light") refuse("direct light", settings.direct);
  if (settings.which_light == "all") return with_roulette<Directions, DirectLight<AllOf>>(settings, render);
  if (settings.which_light == "one") return with_roulette<Directions, DirectLight<OneOf>>(settings, render);
  refuse("choice of light", settings.which_light);
}

void check_ends(const RenderSettings& settings) {
  if (settings.max_depth >= 0) return;
  if (settings.roulette == "off") {
    throw std::invalid_argument("without roulette a path need not end (give --max-depth, or --roulette albedo)");
  }
  if (settings.bounce == "uniform") {
    // A bounce multiplies the second moment by 4/3 rho^2/q, which is above 1 for rho = q > 3/4.
    throw std::invalid_argument(
        "with uniform bounces the variance of endless paths is infinite (give --max-depth)");
  }
}

// The strategies that the settings name, as types: the choice costs nothing inside the loop.
void with_tracer(const RenderSettings& settings, const auto& render) {
  check_ends(settings);
  if (settings.light_sampling != "area") refuse("light sampling", settings.light_sampling);
  if (settings.filter != "tent") refuse("filter", settings.filter);
  if (settings.bounce == "uniform") return with_direct<UniformHemisphere>(settings, render);
  if (settings.bounce == "cosine") return with_direct<CosineHemisphere>(settings, render);
  refuse("bounce", settings.bounce);
}

}  // namespace

RenderCost render_image(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                        int threads, Film& film, const Progress& progress) {
  const StreamKey key(seed, "render");
  const std::vector<Tile> units = tiles(film.width(), film.height());
  RenderCost cost;
  std::mutex mutex;
  int done = 0;
  with_tracer(settings, [&](const auto& tracer) {
    for_each_unit(static_cast<int>(units.size()), threads, [&](int unit) {
      const std::uint64_t rays = render_tile(view, tracer, key, units[static_cast<std::size_t>(unit)], range, film);
      const std::lock_guard lock(mutex);
      cost.rays += rays;
      if (progress) progress(static_cast<double>(++done) / static_cast<double>(units.size()));
    });
  });
  cost.paths = static_cast<std::uint64_t>(film.width()) * static_cast<std::uint64_t>(film.height()) *
               (range.last - range.first);
  return cost;
}

}  // namespace fairlight
