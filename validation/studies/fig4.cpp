#include <cmath>
#include <functional>

#include <fairlight/estimators/allocation_naive.h>
#include <fairlight/estimators/allocation_unbiased.h>
#include <fairlight/estimators/filter.h>
#include <fairlight/estimators/pixel_draws.h>
#include <fairlight/render/path_tracer.h>
#include <fairlight/stats/moments.h>
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

constexpr std::uint64_t samples_each = 256, pilot_each = 64;

using Image = std::vector<double>;
using Draws = std::function<std::vector<double>(std::size_t pixel, std::uint64_t first, std::uint64_t n)>;

struct Form {
  const char* name;
  std::function<Image(const AllocationPlan&, const Draws&)> estimate;
};

// With `pilots` pilots, which share that of the plan.
template <class Allocation>
Form form(const char* name, std::uint64_t pilots) {
  return {name, [pilots](AllocationPlan plan, const Draws& draws) {
            plan.pilot /= pilots;
            return Allocation(plan).estimate(draws);
          }};
}

std::vector<Form> forms() {
  return {{"uniform",
           [](AllocationPlan plan, const Draws& draws) {
             plan.pilot = 0;
             return DiscardedPilot<UniformAllocation>(plan).estimate(draws);
           }},
          form<CrossedHalves<AllocationByDeviation>>("history: deviation, unbiased", 2),
          form<CrossedHalves<AllocationByVariance>>("history: variance, unbiased", 2),
          form<CrossedHalves<AllocationByNeighbours>>("neighbours, unbiased", 2),
          form<naive::PooledStages<AllocationByVariance>>("history: variance, naive", 1),
          form<naive::PooledStages<AllocationByNeighbours>>("neighbours, naive", 1)};
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

// The most that any allocation gains: with known deviations s, mean(s^2) / mean(s)^2.
// Source: Neyman 1934
double known_gain(const std::vector<double>& deviations, const std::vector<bool>& counted) {
  double sum = 0, squares = 0, n = 0;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    if (!counted[i]) continue;
    sum += deviations[i];
    squares += deviations[i] * deviations[i];
    ++n;
  }
  return squares * n / (sum * sum);
}

struct FormRuns {
  std::vector<double> variances, variances_off_light, means;  // of pairs of images
};

// The forms in one view, by one way to find light.
template <class Direct>
class Comparison {
 public:
  Comparison(const View& view, const char* name, const StudyOptions& options)
      : view_(view),
        scene_(view.scene),
        name_(name),
        options_(options),
        size_(options.quick ? 16 : 32),
        pairs_(options.quick ? 6 : 16),
        everywhere_(static_cast<std::size_t>(size_ * size_), true),
        off_light_(pixels_off_lights(view, size_, size_)) {}

  StudyTable table(const std::string& caption, Steps& steps) const {
    StudyTable table{name_,
                     caption,
                     {{"allocation"},
                      {"variance of uniform / variance"},
                      {"the same, off the light"},
                      {"bias of the mean in %"}},
                     {}};
    FormRuns uniform;
    for (const Form& form : forms()) {
      const FormRuns runs = run(form);
      if (uniform.means.empty()) uniform = runs;
      table.rows.push_back({form.name, measured_ratio(uniform.variances, runs.variances),
                            measured_ratio(uniform.variances_off_light, runs.variances_off_light),
                            in_percent(measured_ratio(runs.means, uniform.means))});
      steps.done();
    }
    const std::vector<double> known = deviations();
    table.rows.push_back(
        {"if deviations were known", known_gain(known, everywhere_), known_gain(known, off_light_), 0.0});
    return table;
  }

 private:
  auto draws(const std::string& purpose, std::uint32_t replicate) const {
    const StreamKey key(
        replicate_seed(options_, formatted("fig4 %s %s", name_.c_str(), purpose.c_str()), replicate), "image");
    return PixelDraws<double, GreyPixel<Direct>>(key, 0, GreyPixel<Direct>{scene_, view_.camera, size_});
  }

  FormRuns run(const Form& form) const {
    const auto side = static_cast<std::size_t>(size_);
    const AllocationPlan plan{PixelGrid(side, side), samples_each * side * side, pilot_each};
    std::vector<Image> images(2 * pairs_);
    for_each_unit(images.size(), options_.threads, [&](std::size_t i) {
      images[i] = form.estimate(plan, draws(form.name, static_cast<std::uint32_t>(i)));
    });
    FormRuns runs;
    for (std::size_t i = 0; i < images.size(); i += 2) {
      runs.variances.push_back(half_square_difference(images[i], images[i + 1], everywhere_));
      runs.variances_off_light.push_back(half_square_difference(images[i], images[i + 1], off_light_));
      runs.means.push_back((mean_of(images[i]) + mean_of(images[i + 1])) / 2);
    }
    return runs;
  }

  std::vector<double> deviations() const {
    std::vector<double> deviations(everywhere_.size());
    for_each_unit(deviations.size(), options_.threads, [&](std::size_t pixel) {
      deviations[pixel] = std::sqrt(Moments::of(draws("deviations", 0)(pixel, 0, 4096)).variance());
    });
    return deviations;
  }

  View view_;
  TracedScene<double> scene_;
  std::string name_;
  const StudyOptions& options_;
  int size_;
  std::size_t pairs_;
  std::vector<bool> everywhere_, off_light_;
};

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
    const std::string how = implicit ? "implicit, light of 8.5 m" : "explicit by area, light of 1.5 m";
    const Film film = render_arm({"fig4 map", view, settings, options.quick ? 64u : 1024u}, options, 0).film;
    pictures.push_back(write_map(options, implicit ? "fig4-implicit" : "fig4-explicit",
                                 formatted("log10 of the variance of a sample: %s", how.c_str()),
                                 log_variances(film), settings.width, implicit ? "[-1:2]" : "[-3:1]",
                                 "defined (0 'white', 1 'black')"));
    steps.done();
  }
  return pictures;
}

}  // namespace

StudyResult fig4(const StudyOptions& options) {
  Steps steps(options, 2 * forms().size() + 2);
  StudyResult result;
  result.text = formatted(
      "Where the variance lies, and what it gains to send samples there, at an equal number of samples: %llu a "
      "pixel, a "
      "quarter of them in pilots. The unbiased forms let a sample never count in a mean whose size it decided "
      "(`CrossedHalves`). The naive form, the paper's, pools all samples: pixels that missed their rare bright "
      "paths look "
      "quiet, get no more samples and stay dark. Variance is half the mean square difference of two whole "
      "pictures. The "
      "last row is the most that any allocation could gain. Below 1, the noise of the scores costs more than they "
      "gain.",
      static_cast<unsigned long long>(samples_each));
  const Comparison<DirectLight<AllLights, PointsBy<SphereByCone>>> by_cone(box_with_light(1.5), "explicit",
                                                                           options);
  result.tables.push_back(by_cone.table("Shadow rays by cone, a light of 1.5 m.", steps));
  const Comparison<NoDirectLight> implicit(box_with_light(8.5), "implicit", options);
  result.tables.push_back(implicit.table("Implicit paths, a light of 8.5 m: rare bright samples.", steps));
  result.pictures = maps(options, steps);
  return result;
}

}  // namespace fairlight::studies_of_paper
