#include <cmath>
#include <functional>

#include <fairlight/estimators/allocation_naive.h>
#include <fairlight/estimators/allocation_unbiased.h>
#include <fairlight/estimators/filter.h>
#include <fairlight/estimators/pixel_draws.h>
#include <fairlight/render/path_tracer.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/studies/all_studies.h>
#include <fairlight/validation/studies/pictures.h>
#include <fairlight/validation/studies/renders.h>
#include <fairlight/validation/studies/scenes.h>

namespace fairlight::studies_of_paper {
namespace {

// A small picture of grey radiance, sample by sample.
template <class Direct>
struct GreyPixel {
  using Tracer = PathTracer<BouncesBy<CosineHemisphere>, Direct, RouletteByReflectance<>>;
  const TracedScene<double>& scene;
  const Camera& camera;
  int size;
  Tracer tracer{};

  double operator()(std::size_t pixel, PhiloxStream<double>& source) const {
    const int x = static_cast<int>(pixel) % size, y = static_cast<int>(pixel) / size;
    const Ray<double> ray = pixel_ray(camera, TentFilter<double>(), x, y, size, size, source);
    return tracer.template radiance<double>(scene, ray, source).mean();
  }
};

using Image = std::vector<double>;
using Draws = std::function<std::vector<double>(std::size_t pixel, std::uint64_t first, std::uint64_t n)>;

struct Form {
  const char* name;
  std::function<Image(const AllocationPlan&, const Draws&)> estimate;
};

template <class Allocation>
Form form(const char* name) {
  return {name, [](const AllocationPlan& plan, const Draws& draws) { return Allocation(plan).estimate(draws); }};
}

std::vector<Form> forms() {
  return {{"uniform",
           [](AllocationPlan plan, const Draws& draws) {
             plan.pilot = 0;
             return DiscardedPilot<UniformAllocation>(plan).estimate(draws);
           }},
          form<CrossedHalves<AllocationByDeviation>>("history: deviation, unbiased"),
          form<CrossedHalves<AllocationByVariance>>("history: variance, unbiased"),
          form<CrossedHalves<AllocationByNeighbours>>("neighbours, unbiased"),
          form<naive::PooledStages<AllocationByVariance>>("history: variance, naive"),
          form<naive::PooledStages<AllocationByNeighbours>>("neighbours, naive")};
}

double mean_of(const Image& image) {
  double sum = 0;
  for (const double value : image) sum += value;
  return sum / static_cast<double>(image.size());
}

// Half the mean square difference of two images, which has the variance of a pixel as its mean.
double half_square_difference(const Image& a, const Image& b, const std::vector<bool>& counted) {
  double sum = 0, n = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!counted[i]) continue;
    sum += (a[i] - b[i]) * (a[i] - b[i]) / 2;
    ++n;
  }
  return sum / n;
}

struct FormRuns {
  std::vector<double> variances, variances_off_light, means;  // of pairs of images
};

template <class Direct>
std::vector<FormRuns> run_forms(const View& view, const char* purpose, const StudyOptions& options, int size,
                                std::uint32_t pairs, Steps& steps) {
  const TracedScene<double> scene(view.scene);
  const auto pixels = static_cast<std::size_t>(size);
  const AllocationPlan plan{PixelGrid(pixels, pixels), 64 * pixels * pixels, 8};
  const std::vector<Form> all = forms();
  const std::vector<bool> everywhere(pixels * pixels, true), off_light = pixels_off_lights(view, size, size);
  std::vector<FormRuns> runs(all.size());
  for (std::size_t f = 0; f < all.size(); ++f) {
    std::vector<Image> images(2 * pairs);
    for_each_unit(images.size(), options.threads, [&](std::size_t i) {
      const StreamKey key(
          replicate_seed(options, formatted("fig4 %s %s", purpose, all[f].name), static_cast<std::uint32_t>(i)),
          "image");
      const GreyPixel<Direct> pixel{scene, view.camera, size};
      images[i] = all[f].estimate(plan, PixelDraws<double, GreyPixel<Direct>>(key, 0, pixel));
    });
    for (std::size_t i = 0; i < images.size(); i += 2) {
      runs[f].variances.push_back(half_square_difference(images[i], images[i + 1], everywhere));
      runs[f].variances_off_light.push_back(half_square_difference(images[i], images[i + 1], off_light));
      runs[f].means.push_back((mean_of(images[i]) + mean_of(images[i + 1])) / 2);
    }
    steps.done();
  }
  return runs;
}

Measured in_percent(const Measured& ratio) {
  return {100 * (ratio.value - 1), {100 * (ratio.interval.lo - 1), 100 * (ratio.interval.hi - 1)}};
}

StudyTable table_of(const char* name, const std::string& caption, const std::vector<FormRuns>& runs) {
  StudyTable table{
      name,
      caption,
      {{"allocation"}, {"variance of uniform / variance"}, {"the same, off the light"}, {"bias of the mean in %"}},
      {}};
  const std::vector<Form> all = forms();
  for (std::size_t f = 0; f < all.size(); ++f) {
    table.rows.push_back({all[f].name, measured_ratio(runs[0].variances, runs[f].variances),
                          measured_ratio(runs[0].variances_off_light, runs[f].variances_off_light),
                          in_percent(measured_ratio(runs[f].means, runs[0].means))});
  }
  return table;
}

// The logarithm of the variance of a sample of each pixel, averaged over the channels.
std::vector<double> log_variances(const Film& film) {
  std::vector<double> values;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const Film::Pixel& pixel = film.at(x, y);
      values.push_back(std::log10((pixel[0].variance() + pixel[1].variance() + pixel[2].variance()) / 3));
    }
  }
  return values;
}

std::vector<StudyPicture> maps(const StudyOptions& options, Steps& steps) {
  std::vector<StudyPicture> pictures;
  for (const DirectLighting direct : {DirectLighting::none, DirectLighting::light}) {
    RenderSettings settings;
    settings.width = settings.height = options.quick ? 96 : 160;
    settings.direct = direct;
    const bool implicit = direct == DirectLighting::none;
    const View view = box_with_light(implicit ? 8.5 : 1.5);
    const std::string how = implicit ? "implicit paths, a light of 8.5 m" : "shadow rays by area, a light of 1.5 m";
    const Film film = render_arm({"fig4 map", view, settings, options.quick ? 64u : 1024u}, options, 0).film;
    pictures.push_back(write_map(options, implicit ? "fig4-implicit" : "fig4-explicit",
                                 formatted("log10 of the variance of a sample [(W/(sr m^2))^2]: %s", how.c_str()),
                                 log_variances(film), settings.width, implicit ? "[-1:2]" : "[-3:1]",
                                 "defined (0 'white', 1 'black')"));
    steps.done();
  }
  return pictures;
}

}  // namespace

StudyResult fig4(const StudyOptions& options) {
  const int size = options.quick ? 16 : 32;
  const std::uint32_t pairs = options.quick ? 6 : 30;
  Steps steps(options, 2 * forms().size() + 2);
  StudyResult result;
  result.text =
      "Where the variance lies, and what it gains to send samples there, at an equal number of samples: 64 a "
      "pixel, a "
      "quarter of them in the pilot. The unbiased forms let a sample never count in a mean whose size it decided "
      "(`CrossedHalves`). The naive form, the paper's, pools all samples: pixels that missed their rare bright "
      "paths look "
      "quiet, get no more samples and stay dark. Variance is half the mean square difference of two whole "
      "pictures.";
  result.tables.push_back(
      table_of("explicit", "Shadow rays by area, a light of 1.5 m.",
               run_forms<DirectLight<AllLights>>(box_with_light(1.5), "explicit", options, size, pairs, steps)));
  result.tables.push_back(
      table_of("implicit", "Implicit paths, a light of 8.5 m: rare bright samples.",
               run_forms<NoDirectLight>(box_with_light(8.5), "implicit", options, size, pairs, steps)));
  result.pictures = maps(options, steps);
  return result;
}

}  // namespace fairlight::studies_of_paper
